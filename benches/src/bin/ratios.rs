//! Prints the table of ratios: `ratios [NAME..] [--json FILE]`, where a name selects the rows that begin with it.

use std::process::ExitCode;

use benches::timing::{Budget, Row};

fn main() -> ExitCode {
    let mut names = Vec::new();
    let mut json = None;
    let mut arguments = std::env::args().skip(1);
    while let Some(argument) = arguments.next() {
        if argument == "--json" {
            json = arguments.next();
            if json.is_none() {
                eprintln!("--json needs a file name");
                return ExitCode::from(2);
            }
        } else {
            names.push(argument);
        }
    }
    let mut benches = benches::all();
    if let Some(unknown) = names.iter().find(|name| !benches.iter().any(|b| b.name.starts_with(name.as_str()))) {
        let known: Vec<&str> = benches.iter().map(|b| b.name.as_str()).collect();
        eprintln!("no bench is called {unknown}; there are: {}", known.join(", "));
        return ExitCode::from(2);
    }
    benches.retain(|b| names.is_empty() || names.iter().any(|name| b.name.starts_with(name.as_str())));
    println!("{:<30} {:>12}  {:<14} {:>14} {:>8}", "name", "ours ns", "peer", "peer ns", "ratio");
    let mut rows = Vec::new();
    for bench in &mut benches {
        let row = bench.run(Budget::default());
        print_row(&row);
        rows.push(row);
    }
    println!("ratio = peer / ours, both timed in alternating windows of this run");
    if let Some(file) = json {
        let text = serde_json::to_string_pretty(&rows).map_err(std::io::Error::from);
        if let Err(error) = text.and_then(|text| std::fs::write(&file, text + "\n")) {
            eprintln!("cannot write {file}: {error}");
            return ExitCode::FAILURE;
        }
    }
    ExitCode::SUCCESS
}

fn print_row(row: &Row) {
    println!("{:<30} {:>12.2}  {:<14} {:>14.2} {:>8.3}", row.name, row.ours_ns, row.peer, row.peer_ns, row.ratio);
}
