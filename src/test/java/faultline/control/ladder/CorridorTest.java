package faultline.control.ladder;

import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.control.SensorFinding;
import faultline.control.SensorHealth;
import faultline.engine.ControllerMode;
import faultline.engine.Simulation;
import faultline.scenario.Scenario;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.SplittableRandom;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Along a straight wall, the reading of a healthy sensor stays the same for long; it is not taken for stuck. */
class CorridorTest {

    private static final int MIN_TIME = 30;
    private static final int END = 600;

    @TempDir
    Path folder;

    /** Returns a robot with unequal wheels, which differ from its model, in a corridor in which two discs move. */
    private Simulation corridor(SplittableRandom random) throws Exception {
        String text = String.format(
                Locale.ROOT,
                """
                <scenario xmlns="urn:faultline:scenario:1" name="Corridor" duration="%d">
                  <world width="60" height="3">
                    <circle id="fast" x="9" y="1.5" radius="0.4"><motion speed="0.4" points="2,1.5 58,1.5"/></circle>
                    <circle id="slow" x="40" y="1.5" radius="0.4"><motion speed="0.07" points="58,1.5 2,1.5"/></circle>
                  </world>
                  <robot x="1" y="2.7" heading="0" trackScale="%f"><motor leftScale="%f" rightScale="%f"/></robot>
                  <controller diagnosis="on"/>
                </scenario>
                """,
                END,
                random.nextDouble(0.95, 1.05),
                random.nextDouble(0.95, 1.05),
                random.nextDouble(0.95, 1.05));
        Path file = Files.writeString(folder.resolve("corridor.xml"), text);
        return new Simulation(Scenario.load(file).setup(), ControllerMode.DIRECT);
    }

    @ParameterizedTest
    @ValueSource(longs = {431001, 431002, 431003, 431004, 431005, 431006, 431007, 431008})
    void noHealthySensorIsFoundStuck(long seed) throws Exception {
        Simulation simulation = corridor(new SplittableRandom(seed));
        while (simulation.time() < END && simulation.collision().isEmpty()) {
            simulation.tick();
            List<SensorHealth> health = simulation.telemetry().diagnosis().health();
            assertTrue(
                    health.stream().noneMatch(sensor -> sensor.finding() == SensorFinding.STUCK),
                    () -> health + " at " + simulation.time());
        }
        assertTrue(simulation.time() > MIN_TIME, () -> "the robot drove for " + simulation.time() + " s");
    }
}
