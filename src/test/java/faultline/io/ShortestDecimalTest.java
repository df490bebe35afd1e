package faultline.io;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.charset.StandardCharsets;
import java.util.SplittableRandom;
import java.util.stream.DoubleStream;
import java.util.stream.LongStream;
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

    @Test
    void decimalFractionsReadAsTheJdkWritesThem() {
        SplittableRandom random = new SplittableRandom(13);
        for (int i = 0; i < NUMBERS; i++) {
            int scale = random.nextInt(1, 8);
            long unscaled = random.nextLong(1L << random.nextInt(1, 49));
            int end = ShortestDecimal.writeDecimal(unscaled, scale, TEXT, START);
            assertEquals(
                    Double.toString(unscaled / StrictMath.pow(10, scale)),
                    new String(TEXT, START, end - START, StandardCharsets.ISO_8859_1));
        }
    }

    @Test
    void integersReadAsTheJdkWritesThem() {
        SplittableRandom random = new SplittableRandom(14);
        LongStream edges = LongStream.iterate(1, power -> power <= Long.MAX_VALUE / 10, power -> 10 * power)
                .flatMap(power -> LongStream.of(power - 1, power, power + 1));
        LongStream others = random.longs(NUMBERS).map(bits -> bits >>> 1 + (bits & 0x3F) % 63);
        LongStream.of(Long.MAX_VALUE).forEach(ShortestDecimalTest::assertIntegerText);
        LongStream.concat(edges, others).forEach(ShortestDecimalTest::assertIntegerText);
    }

    private static void assertIntegerText(long integer) {
        int end = ShortestDecimal.writeInteger(integer, TEXT, START);
        assertEquals(Long.toString(integer), new String(TEXT, START, end - START, StandardCharsets.ISO_8859_1));
    }
}
