//! Bad input is a typed error that names the place; the object is unchanged.

use boxlp::{LpError, Problem, Solver};

fn problem() -> Problem {
    let mut problem = Problem::new(2).unwrap();
    problem.push_row(&[1.0, 1.0], 0.0, 0.5).unwrap();
    problem
}

#[test]
fn bad_rows_are_refused() {
    let mut p = problem();
    let before = p.clone();
    assert_eq!(
        p.push_row(&[1.0], 0.0, 1.0),
        Err(LpError::Length {
            expected: 2,
            found: 1
        })
    );
    assert!(
        matches!(p.push_row(&[1.0, f64::NAN], 0.0, 1.0), Err(LpError::Entry { row: 1, column: 1, value }) if value.is_nan())
    );
    assert!(matches!(
        p.push_row(&[f64::INFINITY, 0.0], 0.0, 1.0),
        Err(LpError::Entry {
            row: 1,
            column: 0,
            ..
        })
    ));
    assert_eq!(
        p.push_row(&[1e308, 1e308], 0.0, 1.0),
        Err(LpError::RowOverflow { row: 1 })
    );
    for (lower, upper) in [
        (1.0, 0.0),
        (f64::NAN, 1.0),
        (0.0, f64::NAN),
        (f64::INFINITY, f64::INFINITY),
        (f64::NEG_INFINITY, f64::NEG_INFINITY),
    ] {
        assert!(matches!(
            p.push_row(&[1.0, 1.0], lower, upper),
            Err(LpError::Range { row: 1, .. })
        ));
        assert!(matches!(
            p.set_range(0, lower, upper),
            Err(LpError::Range { row: 0, .. })
        ));
    }
    assert_eq!(
        p.set_range(1, 0.0, 1.0),
        Err(LpError::RowIndex { row: 1, rows: 1 })
    );
    assert_eq!(p, before);
}

#[test]
fn bad_columns_are_refused() {
    let from = Problem::from_columns;
    assert_eq!(
        from(2, &[1.0; 3], &[0.0; 2], &[1.0; 2]),
        Err(LpError::Length {
            expected: 4,
            found: 3
        })
    );
    assert_eq!(
        from(2, &[1.0; 4], &[0.0; 2], &[1.0]),
        Err(LpError::Length {
            expected: 2,
            found: 1
        })
    );
    assert!(matches!(
        from(2, &[1.0, 2.0, f64::NAN, 4.0], &[0.0; 2], &[1.0; 2]),
        Err(LpError::Entry {
            row: 0,
            column: 1,
            ..
        })
    ));
    assert!(matches!(
        from(usize::MAX, &[], &[], &[]),
        Err(LpError::TooLarge { .. })
    ));
    let mut solver = Solver::new(problem());
    assert!(solver.load_columns(1, &[1.0], &[2.0], &[1.0]).is_err());
    // What is left is a box: still an answer.
    assert_eq!(solver.maximize(&[3.0]).unwrap().value, 3.0);
}

#[test]
fn bad_objectives_and_multipliers_are_refused() {
    let mut solver = Solver::new(problem());
    assert!(matches!(
        solver.maximize(&[1.0]),
        Err(LpError::Length {
            expected: 2,
            found: 1
        })
    ));
    assert!(matches!(
        solver.maximize(&[1.0, f64::NAN]),
        Err(LpError::Objective { column: 1, .. })
    ));
    assert!(matches!(
        solver.maximize(&[1e308, 1e308]),
        Err(LpError::ObjectiveOverflow)
    ));
    assert_eq!(
        problem().upper_bound(&[1.0, 1.0], &[(1, 1.0)]),
        Err(LpError::RowIndex { row: 1, rows: 1 })
    );
    let mut message = String::new();
    for error in [
        LpError::Length {
            expected: 2,
            found: 1,
        },
        LpError::Range {
            row: 3,
            lower: 1.0,
            upper: 0.0,
        },
        LpError::Entry {
            row: 0,
            column: 1,
            value: f64::NAN,
        },
    ] {
        message += &format!("{error}; ");
    }
    assert_eq!(
        message,
        "expected 2 entries, found 1; row 3 has no range: [1, 0]; entry (0, 1) of the matrix is NaN, not a finite number; "
    );
}

#[test]
fn odd_but_legal_problems_are_answered() {
    // No variable, no row; rows of zeros; a zero objective; huge and tiny numbers.
    let mut solver = Solver::new(Problem::new(0).unwrap());
    assert_eq!(solver.maximize(&[]).unwrap().bound, 0.0);
    let mut p = Problem::new(2).unwrap();
    p.push_row(&[0.0, 0.0], -1.0, 0.0).unwrap();
    p.push_row(&[0.0, 0.0], f64::NEG_INFINITY, f64::INFINITY)
        .unwrap();
    p.push_row(&[1e300, -1e300], 0.0, 0.0).unwrap();
    p.push_row(&[1e-300, 1e-300], f64::NEG_INFINITY, 1e-300)
        .unwrap();
    let mut solver = Solver::new(p);
    let solution = solver.maximize(&[1.0, 1.0]).unwrap();
    assert!(
        solution.bound >= 1.0 && solution.bound < 1.0 + 1e-9,
        "{solution:?}"
    );
    assert_eq!(solver.maximize(&[0.0, 0.0]).unwrap().gap(), 0.0);
    let tiny = solver.maximize(&[1e-308, 1e-308]).unwrap();
    assert!(tiny.bound >= 1e-308 && tiny.bound < 3e-307);
    let huge = solver.maximize(&[1e307, 1e307]).unwrap();
    assert!(huge.bound >= 1e307 && huge.bound.is_finite());
    // A row of zeros that wants something else is a contradiction.
    solver.push_row(&[0.0, 0.0], 1e-3, 1.0).unwrap();
    assert_eq!(
        solver.maximize(&[1.0, 1.0]).unwrap().status,
        boxlp::Status::Empty
    );
}
