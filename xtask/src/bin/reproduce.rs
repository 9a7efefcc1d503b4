//! `cargo xtask reproduce`: runs experiments and writes their tables and figures.
//!
//! A program of its own, so that the other commands need none of the library crates.

use std::io::IsTerminal;
use std::path::{Path, PathBuf};
use std::process::ExitCode;
use std::sync::Mutex;
use std::time::Instant;

use clap::Parser;
use indicatif::{ProgressBar, ProgressStyle};
use scenarios::html::{Page, index};
use scenarios::{Context, Experiment, Output, Progress, ScenarioError};
use xtask::{data_folder, exit, root};

/// Runs the papers' experiments and writes their tables and figures beside ours.
#[derive(Parser)]
#[command(name = "cargo xtask reproduce", version)]
struct Arguments {
    /// Experiments to run (all by default).
    experiments: Vec<String>,
    /// Monte Carlo runs per case.
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u64).range(1..=1_000_000))]
    runs: Option<u64>,
    /// Seed of all random streams.
    #[arg(long, value_name = "S", default_value_t = 1)]
    seed: u64,
    /// Smaller cases: everything in less than two minutes.
    #[arg(long)]
    quick: bool,
    /// Folder with data that does not ship with the project (else the environment variable ORBITOPE_DATA).
    #[arg(long, value_name = "DIR")]
    data: Option<PathBuf>,
    /// Folder to write to.
    #[arg(long, value_name = "DIR")]
    out: Option<PathBuf>,
    /// Threads to use (all cores by default); the results do not depend on it.
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u64).range(1..=1024))]
    threads: Option<u64>,
}

/// What became of one experiment.
struct Done {
    experiment: &'static dyn Experiment,
    outcome: Result<Output, String>,
}

fn main() -> ExitCode {
    exit(run(&Arguments::parse()))
}

/// Runs the experiments one after the other and writes the files of each as soon as it ends.
fn run(arguments: &Arguments) -> Result<(), String> {
    let experiments = select(&arguments.experiments)?;
    let data = data_folder(arguments.data.as_deref())?;
    let out = arguments.out.clone().unwrap_or_else(|| root().join("target/reproduce"));
    if let Some(threads) = arguments.threads {
        // At most 1024, see the range of the argument.
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads as usize).build_global();
        pool.map_err(|error| format!("cannot start {threads} threads: {error}"))?;
    }
    let mut done = Vec::new();
    let mut failed = Vec::new();
    for experiment in experiments {
        let start = Instant::now();
        let bar = Bar::new(experiment.name());
        let progress = |progress: Progress<'_>| bar.show(progress);
        let context = Context {
            seed: arguments.seed,
            // At most a million, see the range of the argument.
            runs: arguments.runs.map(|runs| runs as usize),
            quick: arguments.quick,
            data: data.as_deref(),
            progress: &progress,
        };
        let result = experiment.run(&context);
        bar.clear();
        let outcome = match result {
            Ok(output) => {
                write(&out.join(experiment.name()), &output)?;
                println!("{}: {:.1} s, {}", experiment.name(), start.elapsed().as_secs_f64(), agreement(&output));
                Ok(output)
            }
            Err(error @ ScenarioError::DataMissing { .. }) => {
                println!("skipped {error}");
                Err(error.to_string())
            }
            Err(error) => {
                let message = chain(&error);
                eprintln!("{} failed: {message}", experiment.name());
                failed.push(experiment.name());
                Err(message)
            }
        };
        done.push(Done { experiment, outcome });
    }
    let pages: Vec<Page<'_>> = pages(&done, &out);
    write_file(&out.join("index.html"), &index(&pages))?;
    println!("written to {}", out.join("index.html").display());
    if failed.is_empty() { Ok(()) } else { Err(format!("failed: {}", failed.join(", "))) }
}

/// The experiments named, in the order of the registry; all if none is named.
fn select(names: &[String]) -> Result<Vec<&'static dyn Experiment>, String> {
    let all = scenarios::all();
    if let Some(unknown) = names.iter().find(|name| all.iter().all(|experiment| experiment.name() != name.as_str())) {
        let list: String = all.iter().map(|e| format!("\n  {:<20} {}", e.name(), e.describe())).collect();
        return Err(format!("there is no experiment {unknown}; there are:{list}"));
    }
    Ok(all.into_iter().filter(|e| names.is_empty() || names.iter().any(|name| name == e.name())).collect())
}

/// One line on how the cells that carry the paper's number compare with it.
fn agreement(output: &Output) -> String {
    let errors: Vec<f64> = output
        .results
        .rows
        .iter()
        .filter(|row| row.reproduces_paper())
        .filter_map(|row| Some((row.get_value()? / row.paper_number()? - 1.0).abs()))
        .collect();
    if errors.is_empty() {
        return format!("{} rows", output.results.rows.len());
    }
    let worst = errors.iter().copied().fold(0.0, f64::max);
    let within = errors.iter().filter(|&&error| error <= 0.05).count();
    format!(
        "{} rows, {} of {} cells within 5 % of the paper, worst {:.0} %",
        output.results.rows.len(),
        within,
        errors.len(),
        100.0 * worst
    )
}

/// A page for each experiment run now, and a pointer to what an earlier run left of the others.
fn pages<'a>(done: &'a [Done], out: &Path) -> Vec<Page<'a>> {
    let page = |experiment: &'static dyn Experiment| {
        let name = experiment.name();
        let outcome = match done.iter().find(|done| done.experiment.name() == name) {
            Some(done) => done.outcome.as_ref().map_err(Clone::clone),
            None if out.join(name).join("report.md").is_file() => {
                Err(format!("Not run this time; `{name}/report.md` is of an earlier run."))
            }
            None => return None,
        };
        Some(Page { name, description: experiment.describe(), outcome })
    };
    scenarios::all().into_iter().filter_map(page).collect()
}

fn write(folder: &Path, output: &Output) -> Result<(), String> {
    for file in output.files().map_err(|error| chain(&error))? {
        write_file(&folder.join(&file.name), &file.text)?;
    }
    Ok(())
}

fn write_file(path: &Path, text: &str) -> Result<(), String> {
    let folder = path.parent().unwrap_or(Path::new("."));
    std::fs::create_dir_all(folder)
        .and_then(|()| std::fs::write(path, text))
        .map_err(|error| format!("cannot write {}: {error}", path.display()))
}

/// An error with its causes.
fn chain(error: &dyn std::error::Error) -> String {
    let mut text = error.to_string();
    let mut source = error.source();
    while let Some(cause) = source {
        text += &format!(": {cause}");
        source = cause.source();
    }
    text
}

/// A progress bar on standard error that appears after a second, and only on a terminal.
struct Bar {
    bar: ProgressBar,
    start: Instant,
    label: Mutex<String>,
}

impl Bar {
    fn new(name: &str) -> Self {
        let bar = ProgressBar::hidden();
        // The template is a constant; a mistake in it would leave indicatif's own style.
        if let Ok(style) = ProgressStyle::with_template("{prefix} {msg} [{bar:30}] {pos}/{len} {elapsed}") {
            bar.set_style(style.progress_chars("=> "));
        }
        bar.set_prefix(name.to_owned());
        Self { bar, start: Instant::now(), label: Mutex::new(String::new()) }
    }

    fn show(&self, progress: Progress<'_>) {
        if self.bar.is_hidden() && std::io::stderr().is_terminal() && self.start.elapsed().as_secs_f64() > 1.0 {
            self.bar.set_draw_target(indicatif::ProgressDrawTarget::stderr());
        }
        if let Ok(mut label) = self.label.lock()
            && *label != progress.label
        {
            progress.label.clone_into(&mut label);
            self.bar.set_message(label.clone());
        }
        self.bar.set_length(progress.total as u64);
        self.bar.set_position(progress.done as u64);
    }

    fn clear(&self) {
        self.bar.finish_and_clear();
    }
}
