package faultline.gui.text;

import static org.junit.jupiter.api.Assertions.assertEquals;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class AngleTextTest {

    @ParameterizedTest
    @CsvSource({
        "0, 1, 0.0",
        "-0.04, 1, 0.0",
        "-0.06, 1, -0.1",
        "90, 2, 90.00",
        "179.96, 1, 180.0",
        "-179.96, 1, 180.0",
        "-179.94, 1, -179.9",
        "-179.996, 2, 180.00",
        "180, 1, 180.0",
        "-180, 1, 180.0",
        "540.01, 1, 180.0",
        "359.99, 2, -0.01",
        "-725, 0, -5"
    })
    void anglesAreRoundedAndThenNormalised(double degrees, int decimals, String text) {
        assertEquals(text, AngleText.degrees(Math.toRadians(degrees), decimals));
    }

    @Test
    void aSignedAngleAlwaysHasASign() {
        assertEquals("+0.00", AngleText.signedDegrees(Math.toRadians(-0.001), 2));
        assertEquals("+0.42", AngleText.signedDegrees(Math.toRadians(0.42), 2));
        assertEquals("-1.50", AngleText.signedDegrees(Math.toRadians(-1.5), 2));
        assertEquals("+180.00", AngleText.signedDegrees(Math.toRadians(-180), 2));
    }
}
