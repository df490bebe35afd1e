package faultline.engine.metrics;

import static org.junit.jupiter.api.Assertions.assertEquals;

import faultline.io.ShortestDecimal;
import java.math.BigDecimal;
import java.nio.charset.StandardCharsets;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class TickTimesTest {

    private static final int START = 3;

    private static String text(TickTimes times, double time, long tick) {
        byte[] text = new byte[START + ShortestDecimal.ROOM];
        int end = times.write(time, tick, text, START);
        return new String(text, START, end - START, StandardCharsets.ISO_8859_1);
    }

    /** Lengths that integers are exact for, and others: too fine, too long, with too many digits. */
    @ParameterizedTest
    @ValueSource(
            doubles = {0.01, 0.001, 0.005, 0.02, 0.1, 0.0123, 1e-7, 3e-7, 1e-8, 1.0, 12.5, 1e7, 1.0 / 3, 123.4567891})
    void timesAndTheirTextsAreThoseOfDecimalArithmetic(double dt) {
        TickTimes times = TickTimes.of(dt);
        SplittableRandom random = new SplittableRandom(13);
        for (int i = 0; i < 20_000; i++) {
            long tick = i < 2000 ? i : random.nextLong(1L << random.nextInt(1, 50));
            double exact =
                    BigDecimal.valueOf(dt).multiply(BigDecimal.valueOf(tick)).doubleValue();
            assertEquals(exact, times.timeOf(tick));
            assertEquals(Double.toString(exact), text(times, exact, tick));
            double rounded = tick * dt;
            assertEquals(Double.toString(rounded), text(times, rounded, tick));
        }
    }

    @Test
    void aTimeWithARoundingErrorIsWrittenWithIt() {
        assertEquals("0.07", text(TickTimes.of(0.01), 0.07, 7));
        assertEquals("0.07", text(TickTimes.of(0.01), 0.07, 8));
        assertEquals("0.07000000000000002", text(TickTimes.of(0.01), 0.07000000000000002, 7));
    }
}
