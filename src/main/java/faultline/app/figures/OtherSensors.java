package faultline.app.figures;

import faultline.control.Telemetry;
import faultline.control.Timing;
import faultline.engine.ControllerMode;
import faultline.engine.Setup;
import faultline.engine.Simulation;
import faultline.sensor.FaultKind;
import faultline.sensor.SensorSpec;
import faultline.world.Command;
import java.io.IOException;
import java.util.List;
import java.util.OptionalDouble;

/**
 * The paper's claim that t_D does not depend on other sensors: every other sensor failed in every way, once from the moment that the spin
 * begins, and once from the start of the run, when the robot may come to stand elsewhere.
 */
final class OtherSensors implements Figure {

    @Override
    public void make(FigureFolder folder) throws IOException {
        Table table = new Table("timing", "failed_sensor", "fault", "t_D_s", "same_bits", "t_D_s_failed_from_the_start", "same_bits_from_the_start");
        for (Timing timing : Timing.values()) {
            Alignment trial = Alignment.usual(timing, 0);
            double sound = tD(trial.setup()).orElseThrow();
            table.row(timing.fileName(), "none", "none", sound, true, sound, true);
            trial.robot().sensors().stream().filter(sensor -> !sensor.id().equals("left")).forEach(sensor -> rows(table, trial, sound, sensor));
        }
        folder.csv("eq4-other-sensors", table);
    }

    private static void rows(Table table, Alignment trial, double sound, SensorSpec sensor) {
        double spin = spinBegins(trial.setup());
        for (FaultKind kind : FaultKind.values()) {
            Command fault = new Command.InjectFault(sensor.id(), kind.fault(kind.usual()));
            OptionalDouble late = tD(failing(trial.setup(), spin, fault));
            OptionalDouble early = tD(failing(trial.setup(), 0, fault));
            table.row(trial.timing().fileName(), sensor.id(), kind.fileName(), late.orElse(Double.NaN), same(late, sound),
                    early.orElse(Double.NaN), same(early, sound));
        }
    }

    private static boolean same(OptionalDouble value, double sound) {
        return value.isPresent() && Double.doubleToLongBits(value.getAsDouble()) == Double.doubleToLongBits(sound);
    }

    private static Setup failing(Setup setup, double at, Command fault) {
        return new Setup(setup.world(), setup.robot(), setup.start(), setup.controller(), List.of(new Setup.Timed(at, fault)), setup.dt(),
                setup.seed(), setup.duration());
    }

    private static double spinBegins(Setup setup) {
        Journey journey = Journey.of(setup.withDuration(10));
        return journey.states().indexOf("TURN") * setup.dt();
    }

    /** The time between F3 and F4 when ALIGN hands over; empty where it never does. */
    private static OptionalDouble tD(Setup setup) {
        try (Simulation simulation = new Simulation(setup, ControllerMode.DIRECT)) {
            while (simulation.time() < setup.duration() && simulation.collision().isEmpty()) {
                simulation.tick();
                Telemetry now = simulation.telemetry();
                if (now.state().equals("FOLLOW")) {
                    return OptionalDouble.of(now.tF4() - now.tF3());
                }
            }
            return OptionalDouble.empty();
        }
    }
}
