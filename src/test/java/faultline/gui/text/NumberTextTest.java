package faultline.gui.text;

import static org.junit.jupiter.api.Assertions.assertEquals;

import org.junit.jupiter.api.Test;

class NumberTextTest {

    @Test
    void aPatternHasDecimalsThatAreOnlyShownIfTheyAreNeeded() {
        assertEquals("0.30", NumberText.ofPattern("0.00##", 0.3));
        assertEquals("0.3045", NumberText.ofPattern("0.00##", 0.3045));
        assertEquals("0.00", NumberText.ofPattern("0.00##", -0.00001));
    }

    @Test
    void timesHaveTheDecimalsOfTheTick() {
        assertEquals("20.00", NumberText.seconds(20.004, 0.01));
        assertEquals("3.00", NumberText.seconds(3, 1));
        assertEquals("20.004", NumberText.seconds(20.004, 0.001));
        assertEquals("0.0375", NumberText.seconds(3 * 0.0125, 0.0125));
        assertEquals("0.03333", NumberText.seconds(2 / 60.0, 1 / 60.0));
        assertEquals("0.00001", NumberText.seconds(1e-5, 1e-5));
    }

    @Test
    void aClockHasAtLeastThreeDecimals() {
        assertEquals("20.004", NumberText.clock(20.004, 0.01));
        assertEquals("0.0375", NumberText.clock(3 * 0.0125, 0.0125));
        assertEquals("0.00001", NumberText.clock(1e-5, 1e-5));
    }

    @Test
    void zeroHasNoSignAndOtherNumbersKeepTheirs() {
        assertEquals("x 0.000  y -0.002", NumberText.format("x %.3f  y %.3f", -0.0004, -0.0016));
        assertEquals("0 %", NumberText.format("%.0f %%", -0.2));
        assertEquals("-0.05, -10, +0.0", NumberText.format("%.2f, %.0f, %+.1f", -0.05, -10.0, 0.01));
    }
}
