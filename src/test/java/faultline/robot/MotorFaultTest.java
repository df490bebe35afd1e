package faultline.robot;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.ValueSource;

/** The models of docs/faults.md. */
class MotorFaultTest {

    @ParameterizedTest
    @CsvSource({
        "WEAK, 0.7, 4, 2.8",
        "WEAK, 0.7, -4, -2.8",
        "WEAK, 0, 4, 0",
        "DEAD, 0, 6, 0",
        "DEAD, 0, -6, 0",
        "DEAD_BAND, 0.5, 4, 3.5",
        "DEAD_BAND, 0.5, -4, -3.5",
        "DEAD_BAND, 0.5, 0.4, 0",
        "DEAD_BAND, 0.5, -0.4, 0"
    })
    void aFaultChangesTheVoltageByItsModel(MotorFaultKind kind, double value, double volts, double expected) {
        assertEquals(expected, kind.createFault(value).apply(volts) + 0.0, 1e-12);
    }

    @ParameterizedTest
    @EnumSource
    void aKindMakesFaultsOfItsOwnKindAndLimits(MotorFaultKind kind) {
        MotorFault fault = kind.createFault(kind.defaultValue());
        assertEquals(kind, fault.kind());
        assertEquals(kind.takesValue() ? kind.defaultValue() : 0, fault.value());
        if (kind.takesValue()) {
            assertThrows(IllegalArgumentException.class, () -> kind.createFault(Math.nextUp(kind.maxValue())));
            assertThrows(IllegalArgumentException.class, () -> kind.createFault(Double.NaN));
        }
    }

    @ParameterizedTest
    @ValueSource(doubles = {Double.NaN, -0.001, 10_001, Double.POSITIVE_INFINITY, Double.NEGATIVE_INFINITY})
    void aFaultBeyondItsLimitsIsRefused(double value) {
        assertThrows(IllegalArgumentException.class, () -> new MotorFault.Weak(value));
        assertThrows(IllegalArgumentException.class, () -> new MotorFault.DeadBand(value));
    }

    @Test
    void aScaleBeyondItsLimitsIsRefused() {
        assertThrows(IllegalArgumentException.class, () -> new DriveScale(0, 1, 1));
        assertThrows(IllegalArgumentException.class, () -> new DriveScale(1, 11, 1));
        assertThrows(IllegalArgumentException.class, () -> new DriveScale(1, 1, Double.NaN));
    }
}
