package faultline.gui.canvas.tool;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.geometry.Vector2;
import java.util.Optional;
import org.junit.jupiter.api.Test;

class MeasureToolTest {

    private final MeasureTool tool = new MeasureTool(() -> 0.02);

    @Test
    void nothingIsMeasuredBeforeTheButtonGoesDown() {
        tool.move(new Vector2(1, 1), false);
        assertEquals(Optional.empty(), tool.measurementText());
    }

    @Test
    void distanceAngleAndBothComponentsAreShown() {
        tool.press(new Vector2(1, 1), false);
        tool.move(new Vector2(2, 2), true);
        tool.release(new Vector2(4, 5));
        assertEquals(Optional.of("5.000 m   53.1°   Δx 3.000 m   Δy 4.000 m"), tool.measurementText());
    }

    @Test
    void aMeasurementThatIsRoundedToZeroHasNoSign() {
        tool.press(new Vector2(0, 0), false);
        tool.release(new Vector2(2, -0.0004));
        assertEquals(Optional.of("2.000 m   0.0°   Δx 2.000 m   Δy 0.000 m"), tool.measurementText());
    }

    @Test
    void keysMoveTheEndOfTheMeasurement() {
        tool.press(new Vector2(1, 1), false);
        tool.release(new Vector2(1, 1));
        tool.moveByKey(new Vector2(1, 3));
        assertEquals(Optional.of("2.000 m   90.0°   Δx 0.000 m   Δy 2.000 m"), tool.measurementText());
    }

    @Test
    void theMeasurementStaysWhileTheMouseMovesAndRestartsWithTheNextPress() {
        tool.press(new Vector2(0, 0), false);
        tool.release(new Vector2(-1, 0));
        tool.move(new Vector2(7, 7), false);
        assertEquals(Optional.of("1.000 m   180.0°   Δx -1.000 m   Δy 0.000 m"), tool.measurementText());
        tool.press(new Vector2(2, 2), false);
        tool.release(new Vector2(2, 1));
        assertEquals(Optional.of("1.000 m   -90.0°   Δx 0.000 m   Δy -1.000 m"), tool.measurementText());
        assertFalse(tool.isDone());
        tool.finish();
        assertTrue(tool.isDone());
    }

    @Test
    void aClickStartsAMeasurementThatTheNextClickEnds() {
        tool.press(new Vector2(0, 0), false);
        tool.release(new Vector2(0.01, 0));
        tool.move(new Vector2(1, 0), false);
        assertEquals(Optional.of("1.000 m   0.0°   Δx 1.000 m   Δy 0.000 m"), tool.measurementText());
        tool.press(new Vector2(0, 2), false);
        tool.release(new Vector2(0, 2));
        tool.move(new Vector2(7, 7), false);
        assertEquals(Optional.of("2.000 m   90.0°   Δx 0.000 m   Δy 2.000 m"), tool.measurementText());
        tool.press(new Vector2(5, 5), false);
        assertEquals(Optional.of("0.000 m   0.0°   Δx 0.000 m   Δy 0.000 m"), tool.measurementText());
    }

    @Test
    void eachPressByKeyStartsAMeasurement() {
        tool.press(new Vector2(1, 1), false);
        tool.release(new Vector2(1, 1));
        tool.moveByKey(new Vector2(1, 3));
        tool.press(new Vector2(1, 3), false);
        tool.release(new Vector2(1, 3));
        assertEquals(Optional.of("0.000 m   0.0°   Δx 0.000 m   Δy 0.000 m"), tool.measurementText());
    }
}
