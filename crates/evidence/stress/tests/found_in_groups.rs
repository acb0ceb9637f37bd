//! States of the groups that once broke a promise, as `cargo xtask stress` printed them.

use elements::half_space::Control;
use persson::variance::Band;
use stress::{
    AdhesionCase, BallCase, Case, Coating, Deformation, Draw, DrawnScan, ElementsCase, Growth, IntervalsCase,
    LawTablesCase, PerssonCase, Reach, RoughnessCase, Shape, SmallMap, SpectraCase, Tally, Trial,
};

/// Puts a state to every test there is, with several choices of what is drawn; returns whether its numbers are taken.
fn assert_sound<C: Case>(case: &C) -> bool {
    const DRAWS: u64 = 8;
    let mut tally = Tally::default();
    for draw in 0..DRAWS {
        let mut trial = Trial::new(&mut tally, "found", draw, (case, Reach::Wide));
        case.test(Reach::Wide, &mut Draw::new(0, draw), &mut trial);
    }
    for ((_, promise), record) in &tally.records {
        assert_eq!(record.broken, 0, "{promise}: {:?}", record.worst);
    }
    tally.refused.is_empty()
}

fn spiked(rows: usize, columns: usize, [length_x_m, length_y_m]: [f64; 2], height_m: f64) -> SmallMap {
    let mut heights_m = vec![0.0; rows * columns];
    heights_m[columns / 2] = height_m;
    SmallMap { rows, columns, length_x_m, length_y_m, heights_m }
}

fn pressed(map: SmallMap, contact_modulus_pa: f64, pressure_pa: f64, tolerance: f64) -> ElementsCase {
    let (periodic, layer, saturation_pa) = (true, None, None);
    ElementsCase { map, periodic, layer, contact_modulus_pa, pressure_pa, saturation_pa, tolerance }
}

/// Heights of 1e-316 m gave NaN: the pressure over that of such waves overflowed.
#[test]
fn maps_of_denormal_heights_are_flat() {
    let heights_m = vec![4.3054366e-316, 4.3054366e-316, 4.3054366e-316, 6.45815493e-316];
    let side_m = 0.03286273974391398;
    let map = SmallMap { rows: 2, columns: 2, length_x_m: side_m, length_y_m: side_m, heights_m };
    assert!(assert_sound(&pressed(map, 19041.46630412386, 1.0298037423612427, 6.471092174392113e-6)));
}

/// The mean of equal heights differs from them in its last place, which was taken for roughness.
#[test]
fn equal_heights_are_flat() {
    let heights_m = vec![1.8858089165099902e-7; 5];
    let map = SmallMap {
        rows: 1,
        columns: 5,
        length_x_m: 5.719839121940979e-7,
        length_y_m: 1.6243723150294623e-7,
        heights_m,
    };
    let case = pressed(map, 1148358367.5377595, 13964673540.225004, 6.522931371545821e-9);
    assert!(assert_sound(&ElementsCase { saturation_pa: Some(353377537428.68634), ..case }));
}

/// Loads that move less than the heights are rounded to gave NaN; they are refused.
#[test]
fn a_load_below_the_rounding_of_the_heights_is_refused() {
    let map = spiked(2, 2, [6.967776180898532e-6; 2], 66452.93146470902);
    let case = pressed(map, 1472519451.6674385, 140.40283644507272, 4.724825090878694e-10);
    assert!(!assert_sound(&case));
    assert!(!assert_sound(&ElementsCase { periodic: false, ..case }));
    let ball = BallCase {
        map: spiked(4, 4, [1.2036642746897419e-11, 2.802228278385977e-12], 0.49792903424770235),
        contact_modulus_pa: 2885511.4019242525,
        radius_m: 4.882214895294587e-10,
        force_n: 9.545004806702004e-24,
        tolerance: 1.64254788838392e-10,
    };
    assert!(!assert_sound(&ball));
}

/// Steps on which a conjugate direction is zero within rounding: with three free points that carry a load, a direction
/// conjugate to the last change is none. The solve ended with a residual of 0.19.
#[test]
fn a_line_of_five_points_converges() {
    let heights_m = vec![
        4.901835654116346e-9,
        3.208293087435667e-9,
        4.680836531515929e-10,
        4.680836531515924e-10,
        3.2082930874356667e-9,
    ];
    let [length_x_m, length_y_m] = [4.6662458417448966e-4, 6.82977668691077e-4];
    let map = SmallMap { rows: 1, columns: 5, length_x_m, length_y_m, heights_m };
    assert!(assert_sound(&pressed(map, 10439755614.830692, 34033.96086635484, 4.7729125039706665e-11)));
}

/// Heights on every other point.
fn checkerboard(
    rows: usize,
    columns: usize,
    [length_x_m, length_y_m]: [f64; 2],
    ends_m: [f64; 2],
) -> SmallMap {
    let at = |point: usize| ends_m[(point / columns + point % columns) % 2];
    let heights_m = (0..rows * columns).map(at).collect();
    SmallMap { rows, columns, length_x_m, length_y_m, heights_m }
}

/// Preconditioned steps that bounds turn into steps of 10^-15, for ever, on the way back from a distance to its load.
#[test]
fn distances_of_checkerboards_are_held() {
    let sides_m = [7.210506913855586e-5, 4.644574203037938e-3];
    let map = checkerboard(11, 5, sides_m, [-2.6894907728570762e-2, -2.8940604844003345e-2]);
    assert!(assert_sound(&pressed(map, 863933858938.8304, 658083118514.4968, 1.3218164968374102e-10)));
    let sides_m = [1.854918204966881e-6, 1.057303376831122e-4];
    let map = checkerboard(57, 1, sides_m, [7.55663824405295e-10, 0.0]);
    assert!(assert_sound(&pressed(map, 1413549.6931712204, 14.270858525267435, 5.907008401574092e-9)));
    let sides_m = [5.252656372755334e-4, 8.44140428748177e-3];
    let map = checkerboard(7, 2, sides_m, [3.490372693827811e-14, 0.0]);
    assert!(assert_sound(&pressed(map, 45.61464674525797, 2.0460652716925793e-10, 4.258395217312189e-9)));
}

/// A pit that is all but closed, whose load rises a thousand times as much with the distance as that of one wave.
#[test]
fn the_distance_of_a_pit_is_held() {
    let mut map = spiked(10, 4, [1723.7042161433653, 87228.92286885653], 0.0);
    map.heights_m[32] = -9.754693241763263e8;
    assert!(assert_sound(&pressed(map, 7723028885680.785, 6.657134756804699e17, 2.448117766117811e-11)));
}

/// Two contacts of a pit are within the tolerance, on two points and on all others: 2400 times the load.
#[test]
fn the_light_load_of_a_pit_is_known_to_the_stiffness_of_all_its_points() {
    let mut map = spiked(8, 8, [2779.1165666906145; 2], 0.0);
    map.heights_m[39] = -1.2987878697662587e-2;
    assert!(assert_sound(&pressed(map, 923.8479660828727, 7.959168375312128e-13, 1.5399259242597977e-9)));
}

/// Loads so near the saturation that rounding of trial pressures lost what is missing: no step, or another load, or a gap
/// of 0.3 or 0.5 rms heights for the shifted map.
#[test]
fn loads_just_below_the_saturation() {
    let saturated = |map, contact_modulus_pa, pressure_pa, saturation_pa, tolerance| ElementsCase {
        saturation_pa: Some(saturation_pa),
        ..pressed(map, contact_modulus_pa, pressure_pa, tolerance)
    };
    let map = checkerboard(2, 2, [2.3028855113919216e-12; 2], [1.2766448651162657e-22, 0.0]);
    let tied = saturated(
        map,
        395387.46385254466,
        3.679504747470214e-17,
        3.6795208718447525e-17,
        5.016024790271369e-10,
    );
    assert!(assert_sound(&tied));
    let steps = (0..54).map(|point| if point % 9 < 4 { 2.4514508128134613 } else { 0.0 });
    let map = SmallMap {
        rows: 6,
        columns: 9,
        length_x_m: 0.10429344614017325,
        length_y_m: 0.06952896409344883,
        heights_m: steps.collect(),
    };
    let steps =
        saturated(map, 2165257741646.3823, 17.94701300641149, 17.94707480001749, 1.662161045652659e-8);
    assert!(assert_sound(&ElementsCase { periodic: false, ..steps }));
    let mut map = spiked(3, 3, [2.2974259009554327e-7, 3.0159603565962417e-7], 0.0);
    map.heights_m[4] = 3.3394064501793073e-11;
    let spike =
        saturated(map, 180383236.18097055, 2.1646399872739495, 2.164639987274117, 5.6693786160245465e-5);
    assert!(assert_sound(&ElementsCase {
        layer: Some((0.017768661286662414, 3.2263140290991107e-9)),
        ..spike
    }));
    let mut map = spiked(1, 3, [230.2200858408894, 76.7400286136298], -0.027743311071472432);
    map.heights_m[0] = 1.3320516843398853;
    map.heights_m[2] = 1.3320516843398853;
    let pit = saturated(
        map,
        1.1521978492907818,
        1.716672390980994e-11,
        1.7166723924726228e-11,
        2.3414217534093877e-5,
    );
    assert!(assert_sound(&pit));
}

/// A flat punch, whose displacements were told apart only to 10^-13 of its side.
#[test]
fn a_flat_punch_has_displacements_of_the_size_of_its_load() {
    let side_m = 4.744720794865332e-9;
    let heights_m = vec![2.0423039583931554e-18; 64];
    let map = SmallMap { rows: 8, columns: 8, length_x_m: side_m, length_y_m: side_m, heights_m };
    let case = pressed(map, 1540490617.9240386, 6.519426769390483, 2.8742448560226475e-11);
    assert!(assert_sound(&ElementsCase { periodic: false, ..case }));
}

/// A spike under no load, which the attraction of the rest does not hold.
#[test]
fn a_spike_without_load() {
    let case = AdhesionCase {
        map: spiked(8, 12, [100.06432714872398, 424.74909658232394], 408873.31991566997),
        contact_modulus_pa: 19322258472.63324,
        work_j_per_m2: 1845086356609.396,
        range_m: 603.205956108081,
        control: Control::PressurePa(0.0),
        from_contact: true,
        tolerance: 6.17559183008778e-6,
    };
    assert_sound(&case);
}

fn persson(
    (youngs_modulus_pa, poisson_ratio): (f64, f64),
    spectrum: &[(f64, f64)],
    band: Band,
    deformation: Deformation,
    pressure_pa: f64,
) -> PerssonCase {
    PerssonCase {
        youngs_modulus_pa,
        poisson_ratio,
        coating: None,
        spectrum: spectrum.to_vec(),
        band,
        deformation,
        energy_factor: Some(0.45),
        threshold: 0.42,
        pressure_pa,
    }
}

/// A spectrum of one sample panicked where the waves of the surface count.
#[test]
fn a_single_sample_has_no_waves() {
    let case = |deformation| persson((1e11, 0.3), &[(1e-6, 1e-24)], Band::Surface, deformation, 1e6);
    assert!(assert_sound(&case(Deformation::Elastic(None))));
    assert!(assert_sound(&case(Deformation::Plastic(1e9, Growth::Power(0.5), None))));
}

/// Holes over which a spectrum falls so steeply that the variance ends before the wavevector does: the hardness was NaN.
#[test]
fn a_hardness_that_grows_after_the_variance_has_ended() {
    let spectrum = [
        (9.38122191305438, 0.004823554465775504),
        (4.923730517052301, 3.7940787440398225e-5),
        (2.6315137799394432, 3.4201608283029046e-7),
        (1.8063942830160025, 2.0228280337071144e-8),
        (0.9895603376130503, 2.1951285798896064e-10),
        (0.00022590842176730815, 9.360819539174714e-38),
        (0.0001879759716075616, 2.3512495998311387e-38),
        (9.045688546239612e-5, 9.631904735281744e-41),
    ];
    let plastic = Deformation::Plastic(562.6556279850519, Growth::Power(1.507488140657112), None);
    let bodies = (1610617.6539537723, 0.3565411696392795);
    assert_sound(&persson(bodies, &spectrum, Band::Surface, plastic, 547.0861937248573));
}

/// Two samples a step of decades apart on a stiff base: a panel narrower than the rounding of the variance gave NaN.
#[test]
fn a_hardness_that_grows_at_once() {
    let spectrum =
        [(1.8752698403315915, 9.172047646888634e-22), (0.0002248464330326439, 6.247769670687624e-50)];
    let plastic = Deformation::Plastic(4.076056931289541, Growth::Power(1.2434875089577078), None);
    let bodies = (613061654143.88, 0.4948988134835846);
    let case = persson(bodies, &spectrum, Band::Surface, plastic, 0.029621737971350363);
    let coating = Some(Coating {
        thickness_m: 211.11320460643583,
        base: Some((2.089826452625311e16, 0.360196368855838)),
    });
    assert_sound(&PerssonCase { coating, ..case });
}

/// Samples of which the last two nearly coincide: the slope beyond them depended on the unit of length.
#[test]
fn the_slope_of_samples_that_nearly_coincide() {
    let spectrum = [
        (5.1110470133339414e-5, 1.2224579110633457e-19),
        (1.7093604715570803e-7, 3.1361778485478524e-25),
        (1.0213968873511673e-8, 5.408162190269889e-28),
        (1.8217977273423767e-9, 1.1022220161134127e-29),
        (1.2375161912741903e-9, 4.6024420537194216e-30),
        (1.2375161912740733e-9, 4.6024420537184386e-30),
    ];
    let rows = vec![
        (4.29466286621715e-5, 46827994.5367585),
        (4.7395749183126426e-7, 158567050.903583),
        (1.756384508984506e-8, 379442796.08857864),
        (8.726706037349246e-10, 556020127.6815819),
    ];
    let plastic = Deformation::Plastic(46827994.5367585, Growth::Table(rows), None);
    assert!(assert_sound(&persson(
        (1543810.360442508, 0.0),
        &spectrum,
        Band::Surface,
        plastic,
        193116.204090544
    )));
}

/// A hardness that grows fourfold over 1e-14 of the variance, which a panel of its own did not resolve: area was lost.
#[test]
fn a_hardness_that_grows_over_the_last_places_of_the_variance() {
    let spectrum = [
        (2.168800061086591e-5, 1.2544922566777223e-20),
        (1.1514485067477321e-5, 5.139335255704491e-21),
        (1.0870217844890457e-5, 4.330090929690099e-21),
        (7.273260644950011e-6, 3.3123772602718885e-21),
        (2.3234122627830207e-9, 8.457804709330178e-32),
        (1.2982565119518575e-9, 2.351388808981027e-32),
        (1.0605221003877145e-9, 3.680143617370909e-35),
        (4.45617481058834e-10, 5.443528235719801e-36),
        (1.7914847039546273e-10, 4.459558224935703e-37),
        (1.7914847037666184e-10, 1.9660026958202578e-39),
        (1.5959043514612131e-10, 1.5388864136753122e-39),
    ];
    let plastic = Deformation::Plastic(2683600.3899806617, Growth::Length(2.1281876853589882e-11), None);
    let bodies = (208236275.85289297, 0.0);
    assert!(assert_sound(&persson(bodies, &spectrum, Band::Profile, plastic, 1625.6516285298821)));
}

/// A hardness that steps far beyond the stress, which was taken for one that the stress still approaches: areas were NaN.
#[test]
fn a_hardness_that_steps_away_from_the_stress() {
    let spectrum = [
        (0.14579329083283982, 4.2570364216065475e-22),
        (0.0662431909751787, 9.065921612465824e-24),
        (3.350553721986963e-5, 2.988235736746761e-27),
        (1.4456193406923806e-5, 4.489821199713841e-26),
        (1.3893594113996774e-5, 3.44943566954654e-26),
        (1.0722545846760949e-5, 8.908042385598189e-27),
        (5.344484524203004e-6, 2.2867539435734642e-28),
        (2.9978821951725474e-6, 1.7711016000201926e-28),
        (1.5895822942646884e-6, 6.422861556695427e-27),
        (2.9077697245861825e-8, 8.531668821330085e-24),
        (2.7754062728471643e-8, 6.528279614586156e-24),
        (1.191374332557396e-8, 4.4700933669814906e-27),
    ];
    let rows = vec![
        (0.16924618204073108, 0.499187449533581),
        (0.01531066830267645, 0.5944076612527698),
        (0.01460074926914417, 2.9077447537384167),
        (0.000357372729824083, 22.816928516287483),
    ];
    let plastic = Deformation::Plastic(0.499187449533581, Growth::Table(rows), Some(274.85644346151963));
    let bodies = (84534676.24431905, 0.5);
    assert_sound(&persson(bodies, &spectrum, Band::Surface, plastic, 0.38170479789037853));
}

/// Holes towards whose end the hardness goes on growing over less and less of the variance: steps of the stress's modes passed over
/// that growth, and the area was larger than that of a constant hardness.
#[test]
fn a_hardness_that_grows_towards_the_end_of_a_variance() {
    let spectrum = [
        (0.008462349421060757, 6.19883339311842e-11),
        (0.0038549346611773607, 1.3266701793091449e-14),
        (0.0025173759547750794, 3.4966513252306463e-15),
        (0.001384095845441398, 5.379633854903789e-16),
        (0.0009947403576678457, 1.9136141128346704e-16),
        (0.0007584155153158396, 8.189006323495266e-17),
        (0.0003343331405507047, 6.3110477816405376e-18),
    ];
    let growth = Growth::Length(1.2000495000301212e-8);
    let plastic = Deformation::Plastic(139124.59524882116, growth, Some(20146379.279328994));
    let bodies = (2996344.6907118363, 0.0);
    assert!(assert_sound(&persson(bodies, &spectrum, Band::Profile, plastic, 1720.8046323353906)));
}

/// A stress eleven decades above the hardness: shares that did not add up to 1, and a march without end.
#[test]
fn a_hardness_far_below_the_stress() {
    let spectrum = [
        (17.778708474236858, 3.635606818504604e-15),
        (15.769601947365327, 1.364645822428628e-15),
        (13.006934071179264, 2.8282982840559214e-16),
        (7.47356939048428, 3.0558202880156385e-18),
        (3.772632489852481, 1.14604988244959e-20),
        (1.2973701823383357, 1.867016405004085e-24),
        (0.2765625849724086, 6.109372203143283e-30),
    ];
    let rows = vec![
        (50.190850363882284, 0.02317511512096266),
        (6.250718474303244, 0.029394654145683652),
        (0.06606460105028279, 0.26732662013831165),
    ];
    let plastic = Deformation::Plastic(0.02317511512096266, Growth::Table(rows), Some(16.659353329398023));
    let bodies = (5823513831270.281, 0.34805682059532655);
    assert_sound(&persson(bodies, &spectrum, Band::Profile, plastic, 0.0225));
}

/// A hardness that does not grow reached its upper limit where the variance ends.
#[test]
fn a_constant_hardness_never_reaches_its_limit() {
    let spectrum = [
        (616.352273354575, 0.010105258911700507),
        (201.20441970915059, 0.009477421342006678),
        (21.032929031752833, 7.565206643899038e-6),
        (1.2592005423685728, 4.777349368633652e-10),
        (0.6921350389836162, 1.2017104010248177e-10),
        (0.002608235421731376, 4.787668693820879e-31),
        (0.00038178277986550464, 7.719296498547957e-31),
    ];
    let plastic = Deformation::Plastic(0.19777609662700377, Growth::Power(0.0), Some(1.6735829151765924));
    let bodies = (16901196667.72611, 0.11818917515232363);
    assert!(assert_sound(&persson(bodies, &spectrum, Band::Surface, plastic, 0.06934617624227242)));
}

/// A pressure thirteen decades below the hardness was lost in the difference of both: a gap share off by 3e-7.
#[test]
fn a_pressure_far_below_the_hardness() {
    let spectrum = [(1e-6, 1e-26), (1e-7, 1e-29)];
    let plastic = Deformation::Plastic(1e18, Growth::Constant, None);
    assert!(assert_sound(&persson((1e9, 0.3), &spectrum, Band::Profile, plastic, 1e5)));
}

/// Two wavelengths that agree to rounding have one wavevector, and no slope between them: moments of the area were NaN.
#[test]
fn wavelengths_that_agree_to_rounding_are_refused() {
    let wavelength_m = 3.3751749523053838e-9f64;
    let rows = vec![
        (9.06925765397715e-6, 5e-23),
        (wavelength_m, 4.6e-29),
        (wavelength_m.next_down(), 4.6e-29),
        (1e-9, 1e-30),
    ];
    assert!(!assert_sound(&SpectraCase { rows, per_decade: 57 }));
}

/// Densities of 1e308 m^3 made moments infinite, and a capacity overflow.
#[test]
fn densities_that_no_surface_has_are_refused() {
    let rows = vec![(1.4e-5, 8e-13), (2.6e-6, f64::MAX), (8e-7, 1.9e307), (1e-8, 1e-155)];
    assert!(!assert_sound(&SpectraCase { rows, per_decade: 6 }));
    assert!(!assert_sound(&SpectraCase { rows: vec![(1e-5, 1e-20), (1e-6, 5e-324)], per_decade: 6 }));
}

/// Shares near 1 and shares below the smallest double were mirrored to NaN.
#[test]
fn intervals_of_areas_at_both_ends() {
    for draws in
        [vec![2.0687e-320, 2.0586e-319], vec![-745.0, -1e-300, -3.0, 1e-12], vec![740.0, 700.0, 600.0]]
    {
        for best in [-1.43e-322, -40.0, -745.0] {
            assert!(assert_sound(&IntervalsCase { draws: draws.clone(), best, level: 0.68 }));
        }
    }
}

/// Draws of 1e-161 lost the digits of their variance, and draws of 1e200 overflowed it.
#[test]
fn draws_of_every_size() {
    let shape = [
        -2.89, 2.40, -0.38, -1.14, 1.46, 1.97, 1.11, 1.88, 0.50, -0.45, -2.91, -1.75, 1.0, -1.27, 0.86, -1.2,
        -2.6,
    ];
    for size in [1e-161, 1.0, 1e200] {
        let draws: Vec<f64> = shape.iter().map(|value| size * value).collect();
        assert!(assert_sound(&IntervalsCase { best: draws[0], draws, level: 0.95 }));
    }
}

/// Overclosures that agree to the last digit of the first gap came back with another pressure; such a range is refused.
#[test]
fn a_law_whose_overclosures_are_lost_is_refused() {
    let case = LawTablesCase {
        shape: Shape::Power(2.5928659738173483),
        length_m: 4.440566203637786e-8,
        range_pa: [1894.6719479376054, 12086779709512.742],
        tolerance: 0.22524262558893815,
        units: interface::finite_elements::UnitSystem::Inches,
    };
    assert!(!assert_sound(&case));
    let huge = LawTablesCase {
        shape: Shape::Plateau(49.8),
        length_m: f64::MAX,
        range_pa: [3.4, 7.0],
        tolerance: 1e-5,
        ..case
    };
    assert!(!assert_sound(&huge));
}

/// Lengths near the smallest double, times a difference of pressures, came out below it.
#[test]
fn a_law_with_gaps_near_the_smallest_double() {
    let case = LawTablesCase {
        shape: Shape::Exponential,
        length_m: 2.2250738585072014e-308,
        range_pa: [57.09081650557628, 57.090816590051084],
        tolerance: 1.5245969905620373e-5,
        units: interface::finite_elements::UnitSystem::Si,
    };
    assert!(assert_sound(&case));
}

fn profile(heights_m: Vec<f64>, missing: Vec<usize>) -> DrawnScan {
    let length_m = 4.9e-6;
    let columns = heights_m.len();
    let (rows, positions_m) = (None, None);
    DrawnScan { columns, rows, length_x_m: length_m, length_y_m: length_m, heights_m, missing, positions_m }
}

/// Heights that are equal but for a pit gave peaks beyond the valleys, by a slope of rounding.
#[test]
fn a_plateau_with_a_pit() {
    let mut heights_m = vec![1.7004798150183264e-7; 9];
    heights_m[1] = 1.700475058418851e-7;
    let scan = profile(heights_m, vec![3]);
    let form = roughness::FormRemoval::None;
    assert!(assert_sound(&RoughnessCase { scan, form, cutoffs_m: [None, None] }));
}

/// A filter drops the only point of a profile that has a height: a panic.
#[test]
fn a_profile_without_heights_behind_its_filter() {
    let heights_m: Vec<f64> = (0..26).map(|at| 1e-7 * f64::from(at % 7)).collect();
    let scan = profile(heights_m, (0..25).collect());
    let form = roughness::FormRemoval::Plane;
    assert!(!assert_sound(&RoughnessCase { scan, form, cutoffs_m: [Some(9.02959175298666e-7), None] }));
}

/// Five points do not determine a form of six numbers: the transposed map had another one.
#[test]
fn fewer_points_than_the_form_has_numbers() {
    let mut heights_m = vec![-0.0016362023817578703; 16];
    heights_m[12] = -0.0018974200568570103;
    let missing = vec![0, 2, 3, 4, 7, 8, 9, 10, 11, 14, 15];
    let scan = DrawnScan { rows: Some(4), columns: 4, ..profile(heights_m, missing) };
    let form = roughness::FormRemoval::SecondOrder;
    assert!(assert_sound(&RoughnessCase { scan, form, cutoffs_m: [None, None] }));
}

/// Six points on two lines do not determine a form of six numbers either.
#[test]
fn points_on_two_lines_of_a_map() {
    let mut heights_m = vec![0.0; 20];
    heights_m[2] = 3.2791937194812533e-9;
    let missing = vec![1, 3, 4, 5, 7, 9, 10, 11, 13, 14, 15, 16, 17, 19];
    let scan = DrawnScan { rows: Some(5), columns: 4, ..profile(heights_m, missing) };
    let form = roughness::FormRemoval::SecondOrder;
    assert!(assert_sound(&RoughnessCase { scan, form, cutoffs_m: [None, None] }));
}

#[test]
fn area_held_by_plastic_flow_stays_where_the_hardness_grows_again_and_again_over_the_last_places_of_the_variance()
 {
    let spectrum = [
        (1.463100777912195e-10, 3.0824361426668262e-27),
        (1.2210026057312963e-10, 4.646049177939309e-27),
        (6.11718753363223e-11, 1.1564852695586442e-27),
        (1.2044527142251694e-13, 6.021216332206303e-50),
        (8.367465533914034e-14, 4.453358876639563e-51),
        (3.519245938872256e-14, 9.048856371557806e-51),
        (1.4424970193402717e-14, 4.980361928389691e-51),
        (1.3722135721756117e-14, 3.911598206693328e-51),
        (1.2372748629878145e-14, 1.5953761745165467e-51),
        (4.977801978329952e-15, 6.666220264850988e-50),
        (1.2016829485676484e-17, 8.822472812323889e-74),
    ];
    let plastic = Deformation::Plastic(18160633.319166075, Growth::Power(0.31859860080694236), None);
    assert!(assert_sound(&persson(
        (306347.94951080706, 0.5),
        &spectrum,
        Band::Profile,
        plastic,
        830237.3717081524
    )));
}

/// Two samples that nearly coincide where the hardness ceases to grow: the modes of the stress do not resolve the layer that the
/// growth leaves at the hardness, and the area rose by 1e-6.
#[test]
fn a_cutoff_just_beyond_the_end_of_a_growing_hardness() {
    let spectrum = [
        (0.0006057683901889965, 5.393428970490687e-19),
        (0.000406997022102838, 1.595808858275822e-19),
        (0.0002108536104569601, 2.130068177520867e-20),
        (9.729958032176007e-5, 1.9948109894537575e-21),
        (3.9412330192966774e-5, 1.2533264686405403e-22),
        (3.3797366456331705e-5, 7.82828373720174e-23),
        (3.235702954341489e-5, 6.850905681835576e-23),
        (1.8571215649811904e-5, 1.2513297097191886e-23),
        (1.0967928215739412e-5, 2.4946232592924996e-24),
        (1.303650777893824e-8, 2.7559147450210884e-33),
        (1.3036507778931366e-8, 2.755914745016639e-33),
        (1.3036417552553187e-8, 2.755856338078773e-33),
        (8.609368151765619e-9, 7.73558460509977e-34),
        (8.23232772160195e-9, 6.7443190303873075e-34),
        (6.17353171066468e-9, 2.79383309765562e-34),
    ];
    let rows = vec![
        (0.0004819741926294577, 452421.49337885715),
        (5.3600218887900235e-6, 500146.39730235806),
        (1.120073428526301e-6, 841846.0960619359),
        (5.921968138538515e-8, 1587137.5328335878),
    ];
    let plastic = Deformation::Plastic(452421.49337885715, Growth::Table(rows), None);
    let bodies = (1972871278.885104, 0.0);
    assert!(assert_sound(&persson(bodies, &spectrum, Band::Surface, plastic, 310369.1912758973)));
}

/// A kink of the hardness just before a cutoff, unresolved by the modes of the stress: the area rose by 2e-8.
#[test]
fn a_cutoff_just_beyond_a_kink_of_the_hardness() {
    let spectrum = [
        (1.7706512907861677e-6, 1.4111637363897727e-22),
        (1.0339148918850854e-6, 1.0751524951343339e-25),
        (7.049654601873402e-7, 6.553981686703761e-26),
        (5.075902139809987e-7, 2.412084197306227e-26),
        (3.379973737363365e-7, 9.419680744338223e-27),
        (3.379973595457801e-7, 9.419680181173654e-27),
        (2.909411997168897e-7, 8.00790934026125e-27),
        (6.207842209718602e-9, 8.502158823763315e-32),
        (3.382013833277426e-9, 3.52756381058596e-32),
        (2.235101016211716e-9, 1.7234334797122434e-32),
    ];
    let plastic = Deformation::Plastic(
        17683.740267697583,
        Growth::Length(1.7764200486508012e-9),
        Some(127131.11748262103),
    );
    let bodies = (125088519.03517404, 0.0);
    assert!(assert_sound(&persson(bodies, &spectrum, Band::Surface, plastic, 17043.57412560865)));
}

/// A layer whose hardness has a kink just before a cutoff: the area rose by 4e-8.
#[test]
fn a_cutoff_just_beyond_a_kink_of_the_hardness_of_a_layer() {
    let spectrum = [
        (2.5181593001890375e-6, 5.170360071520157e-25),
        (1.3118454235743644e-6, 1.269680553768626e-25),
        (6.094855699933721e-7, 4.2503630942058326e-26),
        (3.4137020079629374e-7, 8.665328394126996e-27),
        (3.4136492374545543e-7, 8.665168542082397e-27),
        (1.446921809384627e-7, 1.9917510573531224e-27),
        (7.210195251860792e-8, 4.5362912637822875e-28),
        (4.126358717179547e-8, 1.1355459905015093e-28),
        (2.459909730989932e-8, 6.669413625112522e-29),
        (1.1011621452643789e-8, 2.6863722309418456e-29),
        (9.584275365723469e-9, 1.9637673055790357e-29),
        (3.851131852025242e-9, 1.942772941672073e-30),
        (3.3438711237329883e-9, 1.2371243470460924e-30),
        (1.7181193536144166e-9, 2.9571895312233926e-31),
        (1.6054443208091909e-9, 2.6200682167638514e-31),
        (1.2686208895234945e-9, 1.5035208135136955e-31),
        (1.2106484905879418e-9, 1.3136554468531795e-31),
    ];
    let plastic = Deformation::Plastic(4506.170190848626, Growth::Length(4.165786035433171e-9), None);
    let bodies = (5177426.69072117, 0.0);
    let case = persson(bodies, &spectrum, Band::Profile, plastic, 56.847016495829806);
    let coating = Some(Coating {
        thickness_m: 2.042143603062393e-6,
        base: Some((459096388769.2399, 0.4387009407879007)),
    });
    assert!(assert_sound(&PerssonCase { coating, energy_factor: Some(0.9378928613746746), ..case }));
}

/// A hardness that grows by 1e-4 over 5e-7 of the variance, most of it at the end: the modes of the stress gave an area below p/H,
/// which rose behind it.
#[test]
fn a_hardness_that_grows_at_the_very_end_of_a_variance() {
    let spectrum = [
        (0.00022312883796252186, 8.610453424710607e-16),
        (0.00015983397605869008, 6.723550581079641e-16),
        (6.586056038559209e-5, 3.4842147472368587e-16),
        (3.0114809008799883e-5, 1.9504007407824684e-16),
        (2.8056783580703497e-5, 1.8506733735520737e-16),
        (2.1876218419452188e-5, 2.701888893319815e-19),
        (1.3568324751438758e-5, 1.8960725483541533e-19),
        (6.083686700412029e-6, 1.0460707410705542e-19),
        (4.31958759855094e-6, 8.114990710133949e-20),
        (4.004023042821832e-6, 7.671144391907629e-20),
        (3.1026103899859557e-6, 6.349351089481715e-20),
        (3.1026103897791073e-6, 1.6620648006369195e-21),
        (1.5087399352712735e-6, 9.738406168054157e-22),
        (9.679371507056136e-7, 7.007434702744372e-22),
        (8.601763836331721e-7, 6.420253561426639e-22),
        (4.31054205567691e-7, 3.8465687623988353e-22),
        (3.139860307779835e-7, 3.0411152443779254e-22),
        (1.5808783325170633e-7, 1.828393008931729e-22),
        (7.968664702525406e-8, 1.10021155822999e-22),
        (4.2879214663726645e-8, 6.948980731483511e-23),
    ];
    let plastic = Deformation::Plastic(9228341.219094653, Growth::Length(4.478653509780123e-12), None);
    let bodies = (346874054.6052163, 0.0);
    let case = persson(bodies, &spectrum, Band::Surface, plastic, 2031.4967559739068);
    let coating = Some(Coating {
        thickness_m: 0.01472969755711047,
        base: Some((595431176.2496419, 0.1258696238774374)),
    });
    assert!(assert_sound(&PerssonCase { coating, energy_factor: Some(1.0), ..case }));
}

/// A hardness that grows by 0.3 % at the end of a variance, within one panel: the area was below p/H by 7e-4, and rose behind it.
#[test]
fn a_hardness_that_grows_by_less_than_a_hundredth_at_the_end_of_a_variance() {
    let spectrum = [
        (5.408211558279721e-11, 2.769552597878685e-28),
        (2.188180579998139e-11, 1.4115602310504433e-26),
        (2.101444848211903e-11, 2.0013751015076198e-28),
        (1.7935277606142284e-11, 9.611371878193751e-32),
        (1.3712995370643522e-11, 3.0570512668502327e-31),
        (1.1976370301765288e-11, 2.2573731504164742e-32),
        (5.988509529371217e-12, 2.5126912721765628e-33),
        (2.629291462401469e-12, 5.119172886457328e-38),
        (2.476674354526583e-12, 3.935395261033325e-38),
        (1.0408596124356508e-12, 6.049537630427787e-38),
        (9.056400979925388e-13, 3.1030087231087235e-38),
        (7.420878474168342e-13, 8.871521073583127e-38),
    ];
    let plastic = Deformation::Plastic(3617029286.251824, Growth::Length(3.3919798979822385e-13), None);
    let bodies = (569445254.8918086, 0.0);
    assert!(assert_sound(&persson(bodies, &spectrum, Band::Surface, plastic, 3617029286.2518234)));
}

/// A spectrum that falls steeply: one rule spanned the end of the variance, and the gap under twice the load was off by 7e-5.
#[test]
fn the_gap_of_a_spectrum_that_falls_steeply() {
    let spectrum = [
        (1.8459618448441175e-6, 5.766066461044605e-41),
        (9.70647607608168e-7, 3.419462962090207e-38),
        (8.330047248643019e-7, 4.730244962790005e-38),
        (5.441455974173385e-7, 1.9932953175187134e-38),
        (4.5224059331666344e-7, 8.16831582954593e-39),
        (1.8476839888254e-7, 2.0194702484964371e-38),
        (1.5284333028958968e-7, 4.9842759679650376e-39),
        (6.70767969390808e-10, 2.7314525852382305e-46),
        (6.523854270052802e-10, 2.715772732521344e-46),
        (4.696047687768053e-10, 1.2793101417531167e-45),
        (2.0807568892127803e-10, 5.4345033250371926e-45),
        (1.2706532714069146e-10, 4.152765169372517e-48),
        (1.2706532685911463e-10, 4.152765105872111e-48),
        (9.721403860859128e-11, 6.071612873253114e-49),
    ];
    let plastic = Deformation::Plastic(499.32754273488575, Growth::Power(0.43664688784943206), None);
    let bodies = (62477336.12523363, 0.5);
    let case = persson(bodies, &spectrum, Band::Surface, plastic, 42.32028796948865);
    assert!(assert_sound(&PerssonCase { energy_factor: Some(1.0), ..case }));
}

/// A layer under a spectrum that falls steeply: the stiffness was off the slope of the gap by 2e-9.
#[test]
fn the_gap_of_a_layer_and_a_spectrum_that_falls_steeply() {
    let spectrum = [
        (1.1593572668528541e-9, 2.8148305679656456e-42),
        (1.029359905410563e-9, 1.3358914359363314e-42),
        (8.558950404726322e-10, 4.202489391491838e-43),
        (5.795452142191586e-10, 3.650290142035082e-44),
        (2.8986954524041456e-10, 4.750500003379687e-46),
        (2.390126841321522e-10, 1.418063034038968e-46),
        (1.472533411478836e-10, 6.814521090777934e-48),
        (7.134726530141983e-11, 7.26684502359067e-50),
        (5.130130943808123e-11, 1.2666574510103477e-51),
        (2.155226057726743e-11, 5.1231841263862894e-51),
        (1.1611032244905965e-11, 1.0948278194915355e-53),
        (8.008571121574697e-12, 1.0676036991847992e-54),
        (5.481698095681333e-12, 9.922991569207648e-56),
        (5.097231505084253e-12, 6.291177987399657e-56),
        (9.178638858152553e-15, 3.9729678137466947e-73),
        (5.024883501152873e-15, 9.107294261952656e-75),
        (3.1720873582740085e-15, 3.8954633986844446e-73),
    ];
    let plastic = Deformation::Plastic(3.1831450420471072, Growth::Power(0.9533993513291741), None);
    let bodies = (81374.82296682902, 0.0);
    let case = persson(bodies, &spectrum, Band::Surface, plastic, 0.00386742681809943);
    let coating = Some(Coating {
        thickness_m: 1.874031618165832e-11,
        base: Some((1.761048417326553, 0.2064916015474541)),
    });
    assert!(assert_sound(&PerssonCase { coating, energy_factor: Some(0.45), ..case }));
}
