//! The initial estimates of paper 000 and the numbers of its tables.

use std::f64::consts::{FRAC_PI_2, FRAC_PI_4};

use crate::vehicle::Pose;

/// Steps of a run: one turn of the circle. Not stated in the paper; 1500 to 1650 steps fit its numbers.
pub const STEPS: usize = 1571;

/// The paper's numbers for one filter: `RMSE(theta)`, `RMSE(x)`, `AAR(theta)`, `AAR(x)` as in [`crate::metrics::RunMetrics::NAMES`].
pub type Cells = [f64; 4];

/// One row pair of Table I.
#[derive(Clone, Copy, Debug)]
pub struct InitialEstimate {
    /// ASCII label of the row.
    pub label: &'static str,
    /// The estimate at step 0; the vehicle starts at [`crate::vehicle::INITIAL_POSE`].
    pub pose: Pose,
    /// ART of ZSMF and InZSMF in the paper, s.
    pub paper_step_time_s: [f64; 2],
    /// The paper's numbers for ZSMF.
    pub paper_zsmf: Cells,
    /// The paper's numbers for InZSMF.
    pub paper_inzsmf: Cells,
}

/// Table I, in the paper's order.
pub const TABLE_I: [InitialEstimate; 8] = [
    InitialEstimate {
        label: "theta0=pi/2,x0=(0,0)",
        pose: Pose { heading_rad: FRAC_PI_2, position: [0.0, 0.0] },
        paper_step_time_s: [0.0002948, 0.0006729],
        paper_zsmf: [0.0297466, 0.1765084, 0.5452694, 4.901758],
        paper_inzsmf: [0.0286901, 0.1731275, 0.5081545, 4.3448098],
    },
    InitialEstimate {
        label: "theta0=pi/4,x0=(0,0)",
        pose: Pose { heading_rad: FRAC_PI_4, position: [0.0, 0.0] },
        paper_step_time_s: [0.0002847, 0.0005746],
        paper_zsmf: [0.0607859, 0.1780535, 0.5742719, 4.9474083],
        paper_inzsmf: [0.0588446, 0.1756499, 0.5264049, 4.4215509],
    },
    InitialEstimate {
        label: "theta0=0,x0=(0,0)",
        pose: Pose { heading_rad: 0.0, position: [0.0, 0.0] },
        paper_step_time_s: [0.0003619, 0.000676],
        paper_zsmf: [0.1388153, 0.1834197, 0.5713494, 4.9350339],
        paper_inzsmf: [0.1286731, 0.1726175, 0.5384568, 4.3907049],
    },
    InitialEstimate {
        label: "theta0=pi/2,x0=(5,5)",
        pose: Pose { heading_rad: FRAC_PI_2, position: [5.0, 5.0] },
        paper_step_time_s: [0.0004062, 0.0006746],
        paper_zsmf: [0.1430637, 0.2290812, 0.590817, 5.0174807],
        paper_inzsmf: [0.0727635, 0.2030627, 0.5288208, 4.2914036],
    },
    InitialEstimate {
        label: "theta0=pi/4,x0=(5,5)",
        pose: Pose { heading_rad: FRAC_PI_4, position: [5.0, 5.0] },
        paper_step_time_s: [0.0004163, 0.0006499],
        paper_zsmf: [0.0610256, 0.236809, 0.5699872, 4.9573794],
        paper_inzsmf: [0.0538042, 0.1980891, 0.5102441, 4.3881168],
    },
    InitialEstimate {
        label: "theta0=0,x0=(5,5)",
        pose: Pose { heading_rad: 0.0, position: [5.0, 5.0] },
        paper_step_time_s: [0.0003365, 0.0005168],
        paper_zsmf: [0.4768847, 0.4297928, 0.5609619, 4.9347009],
        paper_inzsmf: [0.2223981, 0.2135912, 0.5469439, 4.41341],
    },
    InitialEstimate {
        label: "theta0=0,x0=(5,-5)",
        pose: Pose { heading_rad: 0.0, position: [5.0, -5.0] },
        paper_step_time_s: [0.0003384, 0.0006246],
        paper_zsmf: [0.1058326, 0.2370771, 0.5934819, 4.9847943],
        paper_inzsmf: [0.0793563, 0.2068291, 0.5292185, 4.3878886],
    },
    InitialEstimate {
        label: "theta0=0,x0=(-5,5)",
        pose: Pose { heading_rad: 0.0, position: [-5.0, 5.0] },
        paper_step_time_s: [0.0004104, 0.000591],
        paper_zsmf: [0.2957031, 0.2724086, 0.5594795, 4.9255123],
        paper_inzsmf: [0.16057, 0.1993127, 0.5510282, 4.4242021],
    },
];

/// Index in [`TABLE_I`] of the initial estimate of Table II and Figure 3.
pub const TABLE_II_CASE: usize = 6;
/// Indices in [`TABLE_I`] of the left and the right column of Figure 2.
pub const FIGURE_2_CASES: [usize; 2] = [0, 5];
/// The poles of Table II.
pub const POLES: [f64; 3] = [0.95, 0.98, 0.98];

/// One row of Table II: method, ART in s, numbers.
pub type TableTwoRow = (&'static str, f64, Cells);

/// Table II. The `RMSE(x)` of its last two rows contradicts Table I, where the other columns of the same runs agree.
pub const TABLE_II: [TableTwoRow; 4] = [
    ("zsmf/pole", 0.0029028, [0.1201428, 0.5982256, 0.7416984, 7.2063406]),
    ("inzsmf/pole", 0.0030225, [0.1176755, 0.5636406, 0.5232929, 3.6078526]),
    ("zsmf", 0.0003384, [0.1058326, 0.2159713, 0.5934819, 4.9847943]),
    ("inzsmf", 0.0006246, [0.0793563, 0.182269, 0.5292185, 4.3878886]),
];
