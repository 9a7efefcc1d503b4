//! What the runs say about the paper and about our filter, in sentences.

use super::paper::METHODS;
use super::plant::START_RADIUS;
use super::studies::{Bound, JUDGED, LARGER_NOISE, LARGER_STEPS, Studies, TABLE_STEPS};
use super::tables::{AGREEMENT, AVERAGED, CONVERGED, is_published, over_zmv, paper_ratio, watched};
use crate::report::significant;
use crate::set_study::Cell;
use crate::set_study::ratios::{average_ratios, average_ratios_to};
use crate::set_study::tables::containment_verdict;
use crate::{Mode, Table};

/// All verdicts.
#[must_use]
pub fn verdicts(studies: &Studies) -> Vec<String> {
    let [printed, smaller] = &studies.tables;
    let mut verdicts = Vec::new();
    if printed.steps() == TABLE_STEPS {
        verdicts.push(zonotopes(printed));
        verdicts.extend(columns(printed, smaller));
    } else {
        verdicts.push(format!(
            "The averages of the paper's Table 3 are over about {TABLE_STEPS} steps; these are over {}, so nothing is compared.",
            printed.steps()
        ));
    }
    verdicts.extend(consistency(printed));
    verdicts.extend(ours(printed));
    if let Some(cell) = find(&studies.larger.rigorous, "rcz") {
        let largest = largest(&cell.at(0, LARGER_STEPS));
        verdicts.push(format!(
            "Rcz at `|v| <= {LARGER_NOISE}`: largest radius {} at `k = {LARGER_STEPS}` of {} runs.",
            significant(largest, 3),
            cell.runs.len()
        ));
    }
    let watched = watched(studies);
    verdicts.push(containment_verdict(watched.iter().map(|(name, cells)| (&**name, *cells))));
    verdicts
}

/// Columns of Table 3 over ZMV at both bounds, and where convergence begins.
#[must_use]
pub fn column_table(studies: &Studies) -> Table {
    let [printed, smaller] = &studies.tables;
    let cell = |value: Option<f64>| value.map_or_else(|| "-".to_owned(), |value| significant(value, 3));
    let header = ["method", "paper", "|v|<=0.15", "|v|<=0.10", "agrees at"].map(str::to_owned);
    let bounds = studies.search.iter().map(|bound| format!("converged at {}", bound.label()));
    let mut table = Table::new(header.into_iter().chain(bounds));
    for (index, method) in METHODS.into_iter().enumerate().skip(1) {
        let (paper, at) = (super::paper::TABLE_3[0][index], [over_zmv(printed, method), over_zmv(smaller, method)]);
        let converged = studies.search.iter().map(|bound| {
            find(&bound.rigorous, method).map_or_else(String::new, |cell| {
                let radii = cell.at(0, JUDGED);
                let count = radii.iter().filter(|&&radius| radius <= CONVERGED * START_RADIUS).count();
                format!("{count} of {}", radii.len())
            })
        });
        let row = [method.to_owned(), significant(paper, 3), cell(at[0]), cell(at[1]), agrees(paper, at).to_owned()];
        table = table.row(row.into_iter().chain(converged));
    }
    table
}

/// At which bound a ratio is that of the paper, within [`AGREEMENT`].
fn agrees(paper: f64, [printed, smaller]: [Option<f64>; 2]) -> &'static str {
    let close = |value: Option<f64>| value.is_some_and(|value| (value / paper).max(paper / value) <= AGREEMENT);
    match (close(printed), close(smaller)) {
        (true, true) => "both",
        (true, false) => "0.15",
        (false, true) => "0.10",
        (false, false) => "neither",
    }
}

fn zonotopes(bound: &Bound) -> String {
    let cells: Vec<&Cell> = bound.published.iter().filter(|cell| is_published(cell)).collect();
    let mut worst = 0.0_f64;
    for over in &cells {
        for of in cells.iter().filter(|of| of.method != over.method) {
            if let Some(paper) = paper_ratio(over, of) {
                worst =
                    average_ratios(of, over).iter().fold(worst, |worst, ratio| worst.max((ratio / paper - 1.0).abs()));
            }
        }
    }
    format!(
        "Zonotope columns of Table 3 (ZMV, ZMV+F, ZFO, ZFO+F among each other): within {:.1} % of the paper over {} steps, which the paper does \
         not state, with `sin(p) / p` as an interval quotient.",
        100.0 * worst,
        bound.steps()
    )
}

fn columns(printed: &Bound, smaller: &Bound) -> Option<String> {
    let verdict = |index: usize| {
        let at = [over_zmv(printed, METHODS[index]), over_zmv(smaller, METHODS[index])];
        agrees(super::paper::TABLE_3[0][index], at)
    };
    let constrained: Vec<usize> = (0..METHODS.len()).filter(|&index| METHODS[index].starts_with("cz")).collect();
    let named = |bound: &str| -> String {
        let names = constrained.iter().filter(|&&index| verdict(index) == bound).map(|&index| METHODS[index]);
        names.map(str::to_uppercase).collect::<Vec<_>>().join(", ")
    };
    let some = |bound: &str| Some(named(bound)).filter(|names| !names.is_empty()).unwrap_or_else(|| "none".to_owned());
    (!printed.rigorous.is_empty()).then(|| {
        format!(
            "Constrained columns of Table 3 over ZMV within a factor of {AGREEMENT}: at the printed `|v| <= 0.15` and at 0.10 {}; at 0.15 only {}; at 0.10 \
             only {}; at neither {}.",
            some("both"),
            some("0.15"),
            some("0.10"),
            some("neither")
        )
    })
}

/// What the consistency step gains.
fn consistency(bound: &Bound) -> Option<String> {
    let ratio = |parts: &str, kind: &str, last: usize| {
        let cell = |name: String| find(&bound.rigorous, &name);
        let ratios = average_ratios_to(last, cell(format!("czfo+{parts}{kind}"))?, cell(format!("czfo{kind}"))?);
        Some(significant(ratios.iter().sum::<f64>() / ratios.len() as f64, 3))
    };
    let both = |kind: &str, last: usize| Some(format!("{} and {}", ratio("c", kind, last)?, ratio("fc", kind, last)?));
    Some(format!(
        "At the printed bound CZFO+C and CZFO+FC are at {} of the radius of CZFO (paper 0.6964 and 0.7290), over `k <= {AVERAGED}` at {}; with \
         eliminations that compare candidates by their hulls (`/compared`, ours) at {} and, over `k <= {AVERAGED}`, at {}. An estimate by single rows \
         often frees a bound that matters, and CZFO alone has nothing to make up for it.",
        both("", usize::MAX)?,
        both("", AVERAGED)?,
        both("/compared", usize::MAX)?,
        both("/compared", AVERAGED)?
    ))
}

fn ours(bound: &Bound) -> Option<String> {
    let (rcz, rival) = (find(&bound.rigorous, "rcz")?, find(&bound.rigorous, "czfo+c")?);
    let mean = |values: Vec<f64>| values.iter().sum::<f64>() / values.len() as f64;
    let average = |cell: &Cell| mean(cell.averages(0, 0, AVERAGED));
    Some(format!(
        "Rcz at the printed bound: radius {} on average over `k <= {AVERAGED}` (CZFO+C {}), {} at `k = {JUDGED}`, at most {} at `k = 20` in {} runs; {} of the \
         radius of CZFO+C on average over all steps.",
        significant(average(rcz), 3),
        significant(average(rival), 3),
        significant(mean(rcz.at(0, JUDGED)), 3),
        significant(largest(&rcz.at(0, 20)), 3),
        rcz.runs.len(),
        significant(mean(average_ratios(rcz, rival)), 3)
    ))
}

fn largest(values: &[f64]) -> f64 {
    values.iter().copied().fold(0.0, f64::max)
}

fn find<'a>(cells: &'a [Cell], method: &str) -> Option<&'a Cell> {
    crate::set_study::study::find(cells, method, Mode::Rigorous)
}
