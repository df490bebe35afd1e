package faultline.gui.panel;

import static faultline.gui.GuiRobot.runOnEdt;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.geometry.Pose;
import faultline.geometry.Vector2;
import faultline.gui.EdtChecker;
import faultline.gui.theme.Theme;
import faultline.robot.RobotSpec;
import faultline.sensor.SensorSpec;
import faultline.world.SensorSnapshot;
import faultline.world.World;
import faultline.world.WorldSpec;
import java.util.List;
import org.junit.jupiter.api.extension.ExtendWith;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

@ExtendWith(EdtChecker.class)
class ReadingBarTest {

    private static final double WORLD = 2000;

    private static SensorSnapshot readingOf(double distance) {
        SensorSpec sensor = new SensorSpec("front", Vector2.ZERO, 0, WORLD, 0.35, true, 0);
        World world = new World(
                new WorldSpec(WORLD, WORLD, true, 0, List.of()),
                RobotSpec.DEFAULT.withSensors(List.of(sensor)),
                new Pose(WORLD - distance, WORLD / 2, 0),
                0.01,
                0);
        world.sense();
        return world.snapshot().sensors().get(0);
    }

    /** A value that is rounded up must fit, too. */
    @ParameterizedTest
    @CsvSource({
        "1.2344, 1.234, 1.234",
        "9.9996, 10.00, 10.000",
        "12.345, 12.35, 12.345",
        "101.52, 101.5, 101.520",
        "999.97, 1000, 999.970"
    })
    void aReadingHasAsManyDecimalsAsTheBarHasRoomFor(double distance, String shown, String exact) {
        SensorSnapshot snapshot = readingOf(distance);
        runOnEdt(() -> {
            Theme.LIGHT.install();
            ReadingBar bar = new ReadingBar(0, "front", ReadingBar.ReadingKind.ACTUAL);
            bar.setSnapshot(snapshot);
            assertEquals(shown, bar.text());
            assertEquals(exact, bar.getAccessibleContext().getAccessibleDescription());
            int width = bar.getFontMetrics(bar.getFont()).stringWidth(bar.text());
            assertTrue(width + 10 <= bar.getPreferredSize().width, width + " pixels");
        });
    }
}
