//! The papers' experiments: plants, simulators, noise, metrics, Monte Carlo runs, figures.
