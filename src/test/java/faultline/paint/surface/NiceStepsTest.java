package faultline.paint.surface;

import static org.junit.jupiter.api.Assertions.assertEquals;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class NiceStepsTest {

    @ParameterizedTest
    @CsvSource({"1, 1", "1.01, 2", "2, 2", "3, 5", "5, 5", "5.5, 10", "7, 10", "0.3, 0.5", "0.012, 0.02", "130, 200"})
    void aStepIsTheNextNiceLength(double metres, double round) {
        assertEquals(round, NiceSteps.atLeast(metres), 1e-12 * round);
    }

    /** Divided by their power of ten, some of them are slightly more than 2 or 5. */
    @Test
    void aNiceLengthIsItsOwnStep() {
        for (int power = -12; power <= 12; power++) {
            for (int leading : new int[] {1, 2, 5}) {
                double nice = Double.parseDouble(leading + "e" + power);
                assertEquals(nice, NiceSteps.atLeast(nice), 1e-12 * nice);
            }
        }
    }

    @ParameterizedTest
    @CsvSource({"1, 1", "9.9, 1", "10, 10", "1000, 1000", "0.001, 0.001", "0.0099, 0.001"})
    void thePowerOfTenIsNotAboveTheNumber(double number, double power) {
        assertEquals(power, NiceSteps.powerOfTen(number));
    }

    @ParameterizedTest
    @CsvSource({"1, 5", "2, 4", "5, 5", "0.2, 4", "0.5, 5", "20, 4", "0.001, 5"})
    void aStepDividesIntoNiceSteps(double round, int parts) {
        assertEquals(parts, NiceSteps.subdivisions(round));
    }

    @ParameterizedTest
    @CsvSource({
        "2000, 2 km",
        "1000, 1 km",
        "500, 500 m",
        "50, 50 m",
        "1, 1 m",
        "0.5, 50 cm",
        "0.01, 1 cm",
        "0.005, 5 mm"
    })
    void aLengthIsNamedInTheUnitThatSuitsIt(double round, String name) {
        assertEquals(name, NiceSteps.format(round));
    }
}
