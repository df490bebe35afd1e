package faultline.scenario.xml;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.math.BigDecimal;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Which numbers are within limits, at the limits and immediately beside them. */
class NumberRangeTest {

    private static NumberRange range(String name) {
        return switch (name) {
            case "cone" -> NumberRange.CONE;
            case "incidence" -> NumberRange.INCIDENCE_ANGLE;
            case "gain" -> NumberRange.GAIN;
            case "size" -> NumberRange.SIZE;
            case "share" -> NumberRange.FRACTION;
            default -> throw new IllegalArgumentException(name);
        };
    }

    @ParameterizedTest
    @CsvSource({
        "cone,      0,                         false",
        "cone,      1e-30,                     true",
        "cone,      179.999999999999999999,    true",
        "cone,      180,                       false",
        "incidence, 0,                         false",
        "incidence, 90,                        true",
        "incidence, 90.000000000000000000001,  false",
        "gain,      0,                         false",
        "gain,      1000000,                   true",
        "size,      0.000001,                  true",
        "size,      100000,                    true",
        "size,      100000.00000000000001,     false",
        "share,     -1e-30,                    false",
        "share,     0,                         true",
        "share,     1,                         true",
        "share,     1.0000000000000000000001,  false"
    })
    void theExactValueIsCompared(String name, BigDecimal value, boolean allowed) {
        assertEquals(allowed, range(name).contains(value));
    }

    /** A double that is a limit may be the rounded value of a number outside. */
    @ParameterizedTest
    @CsvSource({
        "gain,  0,           false",
        "gain,  1e-300,      true",
        "gain,  1000000,     false",
        "gain,  NaN,         false",
        "size,  0.5,         true",
        "share, 0,           false",
        "share, 0.5,         true",
        "share, 1,           false",
        "share, -0.5,        false"
    })
    void aRoundedValueIsInsideIfItIsNoLimit(String name, double rounded, boolean inside) {
        assertEquals(inside, range(name).isInside(rounded));
    }

    @ParameterizedTest
    @CsvSource({
        "share,     from 0 to 1",
        "gain,      more than 0 and at most 1000000",
        "cone,      more than 0 and less than 180 degrees"
    })
    void theRuleSaysWhichLimitsAreAllowed(String name, String rule) {
        assertEquals(rule, range(name).rule().toString());
    }
}
