//! The quick rows of the validation table: theory, to its tolerance.
//!
//! `cargo measure validate` runs the long ones as well and prints all figures.

use hearth_tests::validation::{self, Pace, Verdict, not_reached::NOT_REACHED, table};

/// Every row of the case holds, or is known not to.
fn holds(name: &str) {
    let Some(case) = validation::case(name) else {
        panic!("no case is called {name}");
    };
    assert_eq!(case.pace, Pace::Quick);
    let outcome = (case.run)();
    assert!(!outcome.rows.is_empty());
    for row in outcome.rows {
        assert_ne!(row.verdict(), Verdict::Fails, "{}", table::line(&row));
    }
}

macro_rules! quick {
    ($($(#[$ignored:meta])? $test:ident: $case:literal,)*) => {
        const TESTED: &[&str] = &[$($case),*];
        $(#[test] $(#[$ignored])? fn $test() { holds($case); })*
    };
}

quick! {
    the_kernel_has_the_volume_one: "kernel",
    a_lattice_has_the_density_of_rest: "lattice-density",
    a_linear_pressure_pushes_as_its_gradient: "pressure-gradient",
    a_parabola_has_its_laplacian: "laplacian",
    viscosity_only_ever_takes_energy: "dissipation",
    a_closed_box_keeps_its_momentum: "momentum",
    a_standing_wave_swings_at_c_over_l: "standing-wave",
    a_column_at_rest_is_hydrostatic: "hydrostatic",
    heat_spreads_as_fourier_says: "heat",
    vortices_decay_at_reynolds_20: "taylor-green-20",
    vortices_decay_at_reynolds_100: "taylor-green-100",
    plates_drag_the_gas_as_couette_says: "couette",
    a_force_makes_poiseuilles_parabola: "poiseuille",
    #[ignore = "burns for minutes: `cargo xtask test burns`"]
    the_burner_gives_its_power: "burner-power",
    #[ignore = "burns for minutes: `cargo xtask test burns`"]
    a_gas_flame_is_hottest_at_its_outer_sheet: "outer-sheet",
}

#[test]
fn every_quick_case_is_tested() {
    let quick = validation::cases().filter(|case| case.pace == Pace::Quick);
    let names: Vec<_> = quick.map(|case| case.name).collect();
    assert_eq!(names, TESTED);
}

#[test]
fn rows_that_are_not_reached_have_a_reason() {
    for known in NOT_REACHED {
        assert!(known.reason.len() > 20, "{}", known.row);
    }
}
