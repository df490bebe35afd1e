package faultline.studies;

import faultline.control.Controller;
import faultline.control.ControllerSpec.WallFollowing;
import faultline.control.ControllerState;
import faultline.control.Decision;
import faultline.control.FollowerState;
import faultline.control.Observation;
import faultline.control.PeriodicController;
import faultline.control.TimingRule;
import faultline.control.wallfollower.SpinClock;
import faultline.control.wallfollower.WallFollower;
import faultline.engine.SimulationSetup;
import faultline.geometry.Angles;
import faultline.robot.MotorSpec;
import faultline.robot.RobotSpec;
import faultline.studies.figure.CsvTable;
import faultline.studies.figure.Figure;
import faultline.studies.figure.FigureFolder;
import faultline.studies.figure.SortedSample;
import faultline.world.World;
import java.io.IOException;
import java.util.List;
import java.util.Locale;
import java.util.OptionalDouble;
import java.util.stream.IntStream;

/**
 * Eq. (4) when the controller's model of the motors is wrong: it measures time by the commanded angle according to its
 * model, divided by the constant rate. The range rule with a real clock is compared.
 */
final class MotorMismatch implements Figure {

    private static final int VARIANTS = 12;
    private static final List<Double> FACTORS = List.of(0.8, 0.9, 0.95, 1.0, 1.05, 1.1, 1.2);

    /** The timing of one row of the table. */
    private enum Variant {
        EQUAL_READINGS(TimingRule.EQUAL_READINGS, SpinClock.TURNED_ANGLE),
        RANGE(TimingRule.RANGE, SpinClock.TURNED_ANGLE),
        RANGE_REAL_CLOCK(TimingRule.RANGE, SpinClock.ELAPSED_TIME);

        private final TimingRule rule;
        private final SpinClock clock;

        Variant(TimingRule rule, SpinClock clock) {
            this.rule = rule;
            this.clock = clock;
        }
    }

    /**
     * The true motors as factors of the model: of the time constant and of the speeds of the left and the right wheels.
     */
    private record Mismatch(double timeConstant, double left, double right) {}

    @Override
    public void write(FigureFolder folder) throws IOException {
        CsvTable table = new CsvTable("timing", "quantity", "factor", "n", "median_deg", "min_deg", "max_deg");
        for (Variant variant : Variant.values()) {
            for (double factor : FACTORS) {
                addRow(table, variant, "time_constant", factor, new Mismatch(factor, 1, 1));
                addRow(table, variant, "speed_of_both_wheels", factor, new Mismatch(1, factor, factor));
                addRow(table, variant, "speed_of_right_wheels", factor, new Mismatch(1, 1, factor));
            }
        }
        folder.writeCsv("eq4-mismatch", table);
    }

    private static void addRow(CsvTable table, Variant variant, String quantity, double factor, Mismatch mismatch) {
        SortedSample errors = SortedSample.of(IntStream.range(0, VARIANTS)
                .mapToObj(i -> headingError(variant, i, mismatch))
                .flatMapToDouble(OptionalDouble::stream));
        table.addRow(
                variant.name().toLowerCase(Locale.ROOT).replace('_', '-'),
                quantity,
                factor,
                errors.size(),
                errors.median(),
                errors.min(),
                errors.max());
    }

    /** Returns the heading error at the first tick of FOLLOW, degrees; empty if there is none. */
    private static OptionalDouble headingError(Variant variant, int start, Mismatch mismatch) {
        SimulationSetup setup = AlignmentTrial.standard(variant.rule, start).setup();
        MotorSpec motor = setup.robot().motor();
        RobotSpec real = setup.robot()
                .withMotor(new MotorSpec(
                        mismatch.timeConstant() * motor.timeConstant(), motor.speedConstant(), motor.maxVoltage()));
        World world = new World(setup.world(), real, setup.start(), setup.dt(), setup.seed());
        WallFollowing spec = (WallFollowing) setup.controller();
        Controller follower = new PeriodicController(new WallFollower(spec, variant.clock), spec.period());
        ControllerState before = FollowerState.SEARCH;
        double left = 0;
        double right = 0;
        while (world.tick() * setup.dt() < setup.duration() && world.collision().isEmpty()) {
            world.move(mismatch.left() * left, mismatch.right() * right);
            world.sense();
            Decision decision =
                    follower.decide(new Observation(world.tick(), setup.dt(), setup.robot(), world.reportedReadings()));
            left = decision.leftVolts();
            right = decision.rightVolts();
            ControllerState state = decision.telemetry().state();
            if (state == FollowerState.FOLLOW && before == FollowerState.ALIGN) {
                return OptionalDouble.of(
                        StrictMath.toDegrees(Angles.normalize(world.pose().heading())));
            }
            before = state;
        }
        return OptionalDouble.empty();
    }
}
