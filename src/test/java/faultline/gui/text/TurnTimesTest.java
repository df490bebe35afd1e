package faultline.gui.text;

import static org.junit.jupiter.api.Assertions.assertEquals;

import org.junit.jupiter.api.Test;

class TurnTimesTest {

    @Test
    void theShownTimesSatisfyTheEquation() {
        // Unrounded, t_D = 0.8572 s and t_p = 0.4286 s; a reader of the shown F3 and F4 computes 0.858 s and 0.429 s.
        assertEquals(new TurnTimes("12.126", "12.984", "0.858", "0.4290"), TurnTimes.of(12.12645, 12.98365));
        assertEquals(new TurnTimes("5.000", "5.857", "0.857", "0.4285"), TurnTimes.of(5, 5.857));
    }
}
