package faultline.io;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.charset.StandardCharsets;
import java.util.SplittableRandom;
import java.util.stream.DoubleStream;
import org.junit.jupiter.api.Test;

/** Random numbers are written as the JDK writes them; the system property {@code faultline.numbers} sets how many. */
class ShortestDecimalTest {

    private static final int NUMBERS = Integer.getInteger("faultline.numbers", 100_000);
    private static final int START = 5;
    private static final byte[] TEXT = new byte[START + ShortestDecimal.ROOM];

    private static String text(double number) {
        int end = ShortestDecimal.write(number, TEXT, START);
        return new String(TEXT, START, end - START, StandardCharsets.ISO_8859_1);
    }

    @Test
    void numbersOfAnySizeReadAsTheJdkWritesThem() {
        SplittableRandom random = new SplittableRandom(20_261_122);
        for (int i = 0; i < NUMBERS; i++) {
            double number = (random.nextDouble() - 0.5) * StrictMath.pow(10, random.nextDouble(-30, 12));
            assertEquals(Double.toString(number), text(number));
        }
    }

    @Test
    void numbersWithFewDigitsOrBitsReadAsTheJdkWritesThem() {
        SplittableRandom random = new SplittableRandom(8);
        for (int i = 0; i < NUMBERS; i++) {
            double digits = random.nextInt(1_000_000) / StrictMath.pow(10, random.nextInt(12));
            assertEquals(Double.toString(digits), text(digits));
            double bits = Math.scalb(random.nextInt(1 << 12), -random.nextInt(70));
            assertEquals(Double.toString(bits), text(bits));
            double edge = Math.scalb(1 + random.nextInt(-2, 3) * Math.ulp(1.0), random.nextInt(-80, 30));
            assertEquals(Double.toString(edge), text(edge));
        }
    }

    @Test
    void theBordersOfTheTwoFormsReadAsTheJdkWritesThem() {
        DoubleStream.of(1e7, 1e-3, 1e-24, 1, 10, 0.1, 0.0, -0.0, Double.MIN_VALUE, Double.MAX_VALUE)
                .flatMap(edge -> DoubleStream.of(edge, -edge, Math.nextUp(edge), Math.nextDown(edge)))
                .filter(Double::isFinite)
                .forEach(number -> {
                    assertEquals(Double.toString(number), text(number));
                    assertTrue(text(number).length() <= ShortestDecimal.ROOM);
                });
    }

    /** The text of a power of two is kept; another number must not get it. */
    @Test
    void powersOfTwoReadAsTheJdkWritesThemEachTime() {
        for (int round = 0; round < 2; round++) {
            for (int exponent = Double.MIN_EXPONENT; exponent <= Double.MAX_EXPONENT; exponent++) {
                double power = Math.scalb(1.0, exponent);
                assertEquals(Double.toString(power), text(power));
                assertEquals(Double.toString(-power), text(-power));
            }
        }
        assertEquals("0.0", text(0.0));
        assertEquals("-0.0", text(-0.0));
    }
}
