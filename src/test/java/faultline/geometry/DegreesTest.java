package faultline.geometry;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.math.BigDecimal;
import java.util.Set;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

class DegreesTest {

    @Test
    void theTextOfAnyAngleReadsBackToTheSameBits() {
        SplittableRandom random = new SplittableRandom(4);
        for (int i = 0; i < 20_000; i++) {
            assertReadsBack(random.nextDouble(-10, 10));
            assertReadsBack(random.nextDouble() * Math.pow(10, random.nextInt(-20, 6)));
        }
    }

    @ParameterizedTest
    @ValueSource(doubles = {0, Math.PI, -Math.PI, Math.PI / 2, Double.MIN_NORMAL, 1e-300, 1e6, 0.1, 1})
    void theTextOfASpecialAngleReadsBackToTheSameBits(double radians) {
        assertReadsBack(radians);
    }

    @ParameterizedTest
    @CsvSource({"0", "20", "30", "45", "60", "90", "-135", "180", "179.9", "0.1", "12.34", "359.999"})
    void anAngleTypedInDegreesIsShownAsItWasTyped(String degrees) {
        assertEquals(degrees, Degrees.toText(Degrees.toRadians(Double.parseDouble(degrees))));
    }

    @Test
    void onlyAnglesThatAreReadAreRemembered() {
        Degrees.KNOWN_RADIANS.clear();
        Degrees.toText(0.123456789);
        assertEquals(Set.of(), Degrees.KNOWN_RADIANS.keySet());
        Degrees.toRadians(45);
        assertEquals(Set.of(new BigDecimal("45")), Degrees.KNOWN_RADIANS.keySet());
    }

    /** JDKs before 19 write 2.8421709430404007E-14 and 4.6566128730773926E-10. */
    @Test
    void theShortestTextOfANumberOfDegreesCountsOnEveryJdk() {
        assertEquals(Degrees.toRadians(new BigDecimal("2.842170943040401E-14")), Degrees.toRadians(0x1.0p-45));
        assertEquals(Degrees.toRadians(new BigDecimal("4.656612873077393E-10")), Degrees.toRadians(0x1.0p-31));
        assertEquals(Degrees.toRadians(new BigDecimal("-0.1")), Degrees.toRadians(-0.1));
        assertEquals(0, Degrees.toRadians(-0.0));
    }

    @Test
    void halfATurnIsTheDoubleNearestToPi() {
        assertEquals(Math.PI, Degrees.toRadians(180));
        assertEquals(Math.PI / 2, Degrees.toRadians(90));
    }

    @Test
    void wholeDegreesAreWithinHalfALastDigitOfTheTruth() {
        // pi / 180 to 40 digits, found independently of the class under test.
        BigDecimal perDegree = new BigDecimal("0.01745329251994329576923690768488612713442871888542");
        for (int degrees = -360; degrees <= 360; degrees++) {
            BigDecimal truth = perDegree.multiply(BigDecimal.valueOf(degrees));
            double radians = Degrees.toRadians(degrees);
            BigDecimal error = truth.subtract(new BigDecimal(radians)).abs();
            assertTrue(
                    error.compareTo(new BigDecimal(Math.ulp(radians)).multiply(new BigDecimal("0.5"))) <= 0,
                    degrees + " degrees");
        }
    }

    private static void assertReadsBack(double radians) {
        String text = Degrees.toText(radians);
        assertEquals(radians, Degrees.toRadians(new BigDecimal(text)), text);
        assertEquals(-1, text.indexOf('E'), text);
    }
}
