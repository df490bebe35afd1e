package faultline.app;

import static org.junit.jupiter.api.Assertions.assertEquals;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class TerminalProgressTest {

    @ParameterizedTest
    @CsvSource({"0, 0:00", "59.4, 0:59", "59.5, 1:00", "3599, 59:59", "3600, 1:00:00", "93784, 26:03:04"})
    void aTimeHasHoursOnlyIfThereAreAny(double seconds, String text) {
        assertEquals(text, TerminalProgress.timeText(seconds));
    }
}
