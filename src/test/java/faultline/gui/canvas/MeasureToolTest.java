package faultline.gui.canvas;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.geometry.Vec;
import java.util.Optional;
import org.junit.jupiter.api.Test;

class MeasureToolTest {

    private final MeasureTool tool = new MeasureTool();

    @Test
    void nothingIsMeasuredBeforeTheButtonGoesDown() {
        tool.move(new Vec(1, 1), false);
        assertEquals(Optional.empty(), tool.measure());
    }

    @Test
    void distanceAngleAndBothPartsAreTold() {
        tool.press(new Vec(1, 1), false);
        tool.move(new Vec(2, 2), true);
        tool.release(new Vec(4, 5));
        assertEquals(Optional.of("5.000 m   53.1°   Δx 3.000 m   Δy 4.000 m"), tool.measure());
    }

    @Test
    void theMeasureStaysWhileTheMouseGoesOnAndBeginsAnewWithTheNextPress() {
        tool.press(new Vec(0, 0), false);
        tool.release(new Vec(-1, 0));
        tool.move(new Vec(7, 7), false);
        assertEquals(Optional.of("1.000 m   180.0°   Δx -1.000 m   Δy 0.000 m"), tool.measure());
        tool.press(new Vec(2, 2), false);
        tool.release(new Vec(2, 1));
        assertEquals(Optional.of("1.000 m   -90.0°   Δx 0.000 m   Δy -1.000 m"), tool.measure());
        assertFalse(tool.isDone());
        tool.finish();
        assertTrue(tool.isDone());
    }
}
