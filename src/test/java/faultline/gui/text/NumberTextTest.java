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
    void zeroHasNoSignAndOtherNumbersKeepTheirs() {
        assertEquals("x 0.000  y -0.002", NumberText.format("x %.3f  y %.3f", -0.0004, -0.0016));
        assertEquals("0 %", NumberText.format("%.0f %%", -0.2));
        assertEquals("-0.05, -10, +0.0", NumberText.format("%.2f, %.0f, %+.1f", -0.05, -10.0, 0.01));
    }
}
