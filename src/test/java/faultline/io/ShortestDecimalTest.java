package faultline.io;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.charset.StandardCharsets;
import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import java.util.HexFormat;
import java.util.SplittableRandom;
import java.util.stream.DoubleStream;
import org.junit.jupiter.api.Test;

/**
 * Random numbers are written as the JDK writes them, or shorter if it is older than JDK 19; the system property
 * {@code faultline.numbers} sets how many.
 */
class ShortestDecimalTest {

    private static final int NUMBERS = Integer.getInteger("faultline.numbers", 100_000);
    private static final int START = 5;
    private static final byte[] TEXT = new byte[START + ShortestDecimal.ROOM];

    private static String text(double number) {
        int end = ShortestDecimal.write(number, TEXT, START);
        return new String(TEXT, START, end - START, StandardCharsets.ISO_8859_1);
    }

    /** Before JDK 19, some numbers have a digit too many, or not the nearest digits. */
    private static void assertShortest(double number) {
        String text = text(number);
        String jdk = Double.toString(number);
        if (Runtime.version().feature() >= 19) {
            assertEquals(jdk, text);
        } else if (!text.equals(jdk)) {
            assertEquals(number, Double.parseDouble(text));
            assertTrue(text.length() <= jdk.length(), text);
        }
    }

    @Test
    void numbersOfAnySizeReadAsTheJdkWritesThem() {
        SplittableRandom random = new SplittableRandom(20_261_122);
        for (int i = 0; i < NUMBERS; i++) {
            double number = (random.nextDouble() - 0.5) * StrictMath.pow(10, random.nextDouble(-30, 12));
            assertShortest(number);
        }
    }

    @Test
    void numbersWithFewDigitsOrBitsReadAsTheJdkWritesThem() {
        SplittableRandom random = new SplittableRandom(8);
        for (int i = 0; i < NUMBERS; i++) {
            double digits = random.nextInt(1_000_000) / StrictMath.pow(10, random.nextInt(12));
            assertShortest(digits);
            double bits = Math.scalb(random.nextInt(1 << 12), -random.nextInt(70));
            assertShortest(bits);
            double edge = Math.scalb(1 + random.nextInt(-2, 3) * Math.ulp(1.0), random.nextInt(-80, 30));
            assertShortest(edge);
        }
    }

    @Test
    void theBordersOfTheTwoFormsReadAsTheJdkWritesThem() {
        DoubleStream.of(1e7, 1e-3, 1e-24, 1, 10, 0.1, 0.0, -0.0, Double.MIN_VALUE, Double.MAX_VALUE)
                .flatMap(edge -> DoubleStream.of(edge, -edge, Math.nextUp(edge), Math.nextDown(edge)))
                .filter(Double::isFinite)
                .forEach(number -> {
                    assertShortest(number);
                    assertTrue(text(number).length() <= ShortestDecimal.ROOM);
                });
    }

    /** The text of a power of two is kept; another number must not get it. */
    @Test
    void powersOfTwoReadTheSameEachTime() {
        for (int round = 0; round < 2; round++) {
            for (int exponent = Double.MIN_EXPONENT; exponent <= Double.MAX_EXPONENT; exponent++) {
                double power = Math.scalb(1.0, exponent);
                assertShortest(power);
                assertEquals("-" + text(power), text(-power));
            }
        }
        assertEquals("0.0", text(0.0));
        assertEquals("-0.0", text(-0.0));
    }

    @Test
    void numbersThatOldJdksWriteWithTooManyDigits() {
        assertEquals("5.684341886080802E-14", text(0x1p-44));
        assertEquals("-4.336808689942018E-19", text(-0x1p-61));
        assertEquals("2.0E23", text(2e23));
        assertEquals("1.0E23", text(1e23));
        assertEquals("8.41E21", text(8.41e21));
        assertEquals("9.9E-324", text(2 * Double.MIN_VALUE));
        assertEquals("1.6777216E7", text(0x1p24));
        assertEquals("9.765625E-4", text(0x1p-10));
    }

    /** The hashes are those of the texts of {@code Double.toString} on JDK 25. */
    @Test
    void everyJdkGivesTheTextsOfJdk25() throws NoSuchAlgorithmException {
        MessageDigest texts = MessageDigest.getInstance("SHA-256");
        for (int exponent = Double.MIN_EXPONENT - 52; exponent <= Double.MAX_EXPONENT; exponent++) {
            add(texts, Math.scalb(1.0, exponent));
        }
        assertEquals(
                "c3e77db33c9a645da632ca38c01d02088c7a06bbf8fe7ccbaeb53a8fb929a7aa",
                HexFormat.of().formatHex(texts.digest()));
        SplittableRandom random = new SplittableRandom(44);
        for (int i = 0; i < 100_000; i++) {
            double number = Double.longBitsToDouble(random.nextLong() & Long.MAX_VALUE);
            if (Double.isFinite(number)) {
                add(texts, number);
            }
        }
        assertEquals(
                "32ed8a2b322c7c1823f26e5a253655deb9fe83e64ba3f591b12510cc01d96d69",
                HexFormat.of().formatHex(texts.digest()));
    }

    private static void add(MessageDigest texts, double number) {
        texts.update((text(number) + "\n").getBytes(StandardCharsets.ISO_8859_1));
    }
}
