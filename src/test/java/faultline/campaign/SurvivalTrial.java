package faultline.campaign;

import faultline.control.ControllerSpec;
import faultline.control.WallSide;
import faultline.engine.CommandListener;
import faultline.engine.ControllerFactory;
import faultline.engine.ControllerMode;
import faultline.engine.Simulation;
import faultline.engine.SimulationSetup;
import faultline.engine.SimulationSetup.TimedCommand;
import faultline.engine.metrics.CarryOnMetrics;
import faultline.engine.metrics.DiagnosisMetrics;
import faultline.robot.DriveScale;
import faultline.robot.RobotSpec;
import faultline.sensor.SensorSpec;
import faultline.world.Command;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.SplittableRandom;

/**
 * One run in a random room, until it is known whether the robot carried on.
 *
 * @param room the seed of the room and of all that is drawn
 * @param faults set in at random moments of the first minute
 * @param sensors those that fail, for each fault
 * @param off the sensors that are off from the start, a bit for each
 * @param conditions all else
 */
record SurvivalTrial(long room, List<DrawnFault> faults, List<Integer> sensors, int off, Conditions conditions) {

    /** The eight standard sensors in their order. */
    static final List<String> SENSORS =
            List.of("front", "front-left", "left", "rear-left", "rear", "rear-right", "right", "front-right");

    /**
     * What is the same in all runs of a study.
     *
     * @param diagnosis whether it is on
     * @param side that the wall is kept on
     * @param noise of all sensors, metres
     * @param mismatch the most that wheels and track differ from what the controller believes, as a share
     */
    record Conditions(boolean diagnosis, WallSide side, double noise, double mismatch) {
        static final Conditions STANDARD = new Conditions(true, WallSide.LEFT, 0, 0);
    }

    /** The result of a run. */
    record Outcome(
            SurvivalTrial trial,
            boolean contact,
            boolean carriedOn,
            boolean stopped,
            double share,
            double delay,
            int falseAlarms,
            boolean lowerRung,
            double seconds,
            String note) {}

    private double scale(SplittableRandom random) {
        return 1 + conditions.mismatch * (2 * random.nextDouble() - 1);
    }

    private RobotSpec robot(SplittableRandom random) {
        List<SensorSpec> specs = new ArrayList<>();
        for (int i = 0; i < SENSORS.size(); i++) {
            specs.add(RobotSpec.DEFAULT
                    .sensors()
                    .get(i)
                    .withNoise(conditions.noise)
                    .withOn((off >> i & 1) == 0));
        }
        return RobotSpec.DEFAULT
                .withSensors(specs)
                .withDriveScale(new DriveScale(scale(random), scale(random), scale(random)));
    }

    SimulationSetup setup() {
        SplittableRandom random = new SplittableRandom(room * 7919 + 13);
        RandomRoom place = RandomRoom.ofSeed(room);
        RobotSpec robot = robot(random);
        List<TimedCommand> timeline = new ArrayList<>();
        for (int i = 0; i < faults.size(); i++) {
            timeline.add(new TimedCommand(
                    3 + 60 * random.nextDouble(),
                    new Command.InjectFault(
                            SENSORS.get(sensors.get(i)), faults.get(i).draw(random))));
        }
        ControllerSpec controller =
                ControllerSpec.WallFollowing.DEFAULT.withSide(conditions.side).withDiagnosis(conditions.diagnosis);
        return SimulationSetup.of(place.world(), place.start())
                .withRobot(robot)
                .withController(controller)
                .withTimeline(timeline)
                .withSeed(room)
                .withDuration(36_000);
    }

    Outcome run() {
        SimulationSetup setup = setup();
        CarryOnMetrics metrics = new CarryOnMetrics(setup, CarryOnMetrics.circuit(setup));
        DiagnosisMetrics diagnosis = new DiagnosisMetrics(setup);
        try (Simulation simulation = new Simulation(
                setup, ControllerFactory.create(setup.controller()), ControllerMode.DIRECT, CommandListener.NONE)) {
            while (!metrics.isDecided()) {
                simulation.tick();
                metrics.observe(simulation);
                diagnosis.observe(simulation);
            }
            return outcome(simulation, metrics, diagnosis);
        }
    }

    private Outcome outcome(Simulation simulation, CarryOnMetrics metrics, DiagnosisMetrics diagnosis) {
        String contact = simulation
                .collision()
                .map(hit -> String.format(Locale.ROOT, "%s at %.2f", hit.obstacle(), hit.time()))
                .orElse("-");
        boolean lower = simulation.telemetry().diagnosis().health().stream()
                .anyMatch(health -> !health.isTrusted() && (off >> SENSORS.indexOf(health.sensor()) & 1) == 0);
        return new Outcome(
                this,
                simulation.collision().isPresent(),
                metrics.carriedOn(),
                diagnosis.rung().equals("STOP"),
                metrics.share().orElse(0),
                diagnosis.detectionDelay().orElse(Double.NaN),
                diagnosis.falseAlarms().orElse(0),
                lower,
                simulation.time(),
                String.format(
                        Locale.ROOT,
                        "room %d %s off %s contact %s share %.2f rung %s end %.1f %s",
                        room,
                        conditions.side,
                        Integer.toBinaryString(off),
                        contact,
                        metrics.share().orElse(0),
                        diagnosis.rung(),
                        simulation.time(),
                        simulation.setup().timeline()));
    }
}
