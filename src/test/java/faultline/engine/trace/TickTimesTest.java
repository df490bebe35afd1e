package faultline.engine.trace;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.math.BigDecimal;
import java.util.SplittableRandom;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class TickTimesTest {

    /** Lengths that integers are exact for, and others: too fine, too long, with too many digits. */
    @ParameterizedTest
    @ValueSource(
            doubles = {
                0.01,
                0.001,
                0.005,
                0.02,
                0.1,
                0.0123,
                1e-7,
                3e-7,
                1.2e-7,
                1e-8,
                1.0,
                12.5,
                1e7,
                1.0 / 3,
                123.4567891,
                123456789.1234567
            })
    void timesAreThoseOfDecimalArithmetic(double dt) {
        TickTimes times = TickTimes.of(dt);
        SplittableRandom random = new SplittableRandom(13);
        for (int i = 0; i < 20_000; i++) {
            long tick = i < 2000 ? i : random.nextLong(1L << random.nextInt(1, 50));
            double exact =
                    BigDecimal.valueOf(dt).multiply(BigDecimal.valueOf(tick)).doubleValue();
            assertEquals(exact, times.timeOf(tick));
        }
    }
}
