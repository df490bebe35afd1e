package faultline.app;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.io.ByteArrayOutputStream;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class TerminalProgressTest {

    private static final long SECOND = 1_000_000_000;

    /** A clock may show negative times. */
    private long now = -7 * SECOND;

    private final ByteArrayOutputStream bytes = new ByteArrayOutputStream();
    private final PrintStream out = new PrintStream(bytes, false, StandardCharsets.UTF_8);

    private String shown() {
        String text = bytes.toString(StandardCharsets.UTF_8);
        bytes.reset();
        return text;
    }

    private static String bar(int filled, String text) {
        return "\r[" + "#".repeat(filled) + ".".repeat(40 - filled) + "] " + text + " left   ";
    }

    @Test
    void theBarGrowsWithTheWorkAndShowsTheTimeLeftAtTheSameRate() {
        TerminalProgress progress = new TerminalProgress(out, true, () -> now);
        now += 10 * SECOND;
        progress.update(1, 4);
        assertEquals(bar(10, "1/4, 0:30"), shown());
        now += 10 * SECOND;
        progress.update(2, 4);
        assertEquals(bar(20, "2/4, 0:20"), shown());
    }

    @Test
    void workThatWasDoneBeforeDoesNotCountForTheRate() {
        TerminalProgress progress = new TerminalProgress(out, true, () -> now);
        now += 2 * SECOND;
        progress.update(51, 100);
        assertEquals(bar(20, "51/100, 1:38"), shown(), "49 more at two seconds each");
    }

    @Test
    void theBarIsShownFiveTimesASecondAndAtTheEnd() {
        TerminalProgress progress = new TerminalProgress(out, true, () -> now);
        progress.update(1, 3);
        assertEquals(bar(13, "1/3, 0:00"), shown(), "at once");
        now += SECOND / 5 - 1;
        progress.update(2, 3);
        assertEquals("", shown());
        now++;
        progress.update(2, 3);
        assertEquals(bar(26, "2/3, 0:00"), shown());
        progress.update(3, 3);
        assertEquals(bar(40, "3/3, 0:00"), shown());
        progress.close();
        out.flush();
        assertEquals(System.lineSeparator(), shown());
    }

    @Test
    void nothingIsShownWithoutWorkOrWithoutATerminal() {
        new TerminalProgress(out, true, () -> now).close();
        TerminalProgress invisible = new TerminalProgress(out, false, () -> now);
        invisible.update(1, 1);
        invisible.close();
        out.flush();
        assertEquals("", shown());
    }

    @ParameterizedTest
    @CsvSource({"0, 0:00", "59.4, 0:59", "59.5, 1:00", "3599, 59:59", "3600, 1:00:00", "93784, 26:03:04"})
    void aTimeHasHoursOnlyIfThereAreAny(double seconds, String text) {
        assertEquals(text, TerminalProgress.timeText(seconds));
    }
}
