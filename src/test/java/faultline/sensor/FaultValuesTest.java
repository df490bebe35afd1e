package faultline.sensor;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.lang.reflect.InvocationTargetException;
import java.util.EnumSet;
import java.util.Locale;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

/** Faults at the limits of their values and of the sensor's range, and what each kind says about itself. */
class FaultValuesTest {

    private static final double RANGE = 0.8;
    private static final double NEIGHBOUR = 0.2;
    private static final long STREAM = SensorRandom.streamKey(7, "left");
    private static final SensorSpec SPEC = SensorSpecTest.LEFT;

    private static double apply(Fault fault, double reading) {
        FaultContext context = new FaultContext(100, 0.01, 0.33);
        return fault.apply(reading, context.at(100, RANGE, NEIGHBOUR, SensorRandom.forTick(STREAM, 100)));
    }

    @Test
    void aDeadSensorIsOff() {
        assertTrue(Reading.isOff(apply(new Fault.Dead(), 0.4)));
    }

    @Test
    void aStuckSensorReportsItsDistanceUpToTheRange() {
        assertEquals(0.3, apply(new Fault.Stuck(0.3), 0.4));
        assertEquals(0.3, apply(new Fault.Stuck(0.3), Reading.NOTHING));
        assertEquals(RANGE, apply(new Fault.Stuck(RANGE), 0.4));
        assertEquals(Reading.NOTHING, apply(new Fault.Stuck(Math.nextUp(RANGE)), 0.4));
    }

    @Test
    void aBiasIsAddedWithinZeroAndTheRange() {
        assertEquals(0.5, apply(new Fault.Bias(0.125), 0.375));
        assertEquals(0, apply(new Fault.Bias(-0.5), 0.4));
        assertEquals(RANGE, apply(new Fault.Bias(0.4), 0.4));
        assertEquals(Reading.NOTHING, apply(new Fault.Bias(0.5), 0.4));
        assertEquals(Reading.NOTHING, apply(new Fault.Bias(-0.5), Reading.NOTHING));
    }

    @Test
    void aScaledReadingAtTheRangeIsKept() {
        assertEquals(RANGE, apply(new SignalFault.Scale(2), 0.4));
    }

    @Test
    void dirtKeepsWhatIsExactlyAtItsRange() {
        assertEquals(0.2, apply(new OpticalFault.ShortRange(0.2), 0.2));
    }

    @Test
    void noiseIsAddedFromTheSensorsRandomNumbers() {
        double normal = SensorRandom.forTick(STREAM, 100).nextGaussian();
        assertEquals(0.4 + 0.01 * normal, apply(new SignalFault.Noise(0.01), 0.4));
    }

    @Test
    void crossTalkReportsTheNextSensorsReadingIfItIsNearer() {
        assertEquals(NEIGHBOUR, apply(new SignalFault.CrossTalk(1), 0.4));
        assertEquals(0.1, apply(new SignalFault.CrossTalk(1), 0.1));
        assertEquals(0.4, apply(new SignalFault.CrossTalk(0), 0.4));
    }

    @Test
    void aGhostIsNotFartherThanTheReading() {
        SensorRandom random = SensorRandom.forTick(STREAM, 100);
        random.nextDouble();
        double distance = RANGE * random.nextDouble();
        assertEquals(distance, apply(new SignalFault.Ghost(1), Reading.NOTHING));
        assertEquals(distance / 2, apply(new SignalFault.Ghost(1), distance / 2));
    }

    @Test
    void faultsOfTheOpticsChangeTheConeAndNotTheReading() {
        Fault cone = new OpticalFault.Cone(4);
        Fault turned = new OpticalFault.Misaligned(30);
        Fault specular = new OpticalFault.SpecularLoss(30);
        for (Fault fault : Set.of(cone, turned, specular)) {
            assertEquals(0.4, apply(fault, 0.4));
        }
        assertEquals(SPEC.withCone(StrictMath.toRadians(4)), cone.optics(SPEC));
        assertEquals(
                SPEC.bearing() + StrictMath.toRadians(30), turned.optics(SPEC).bearing(), 1e-15);
        assertEquals(StrictMath.toRadians(30), specular.specularAngle());
        assertSame(SPEC, specular.optics(SPEC));
        assertEquals(StrictMath.PI / 2, cone.specularAngle());
    }

    @Test
    void theRandomNumbersOfATickAreThoseOfTheDocumentedMixer() {
        // Computed in another language.
        SensorRandom random = SensorRandom.forTick(STREAM, 12_345);
        assertEquals(0.535373854607369, random.nextDouble());
        assertEquals(0.5243843564324708, random.nextDouble());
        assertEquals(0.7549429574292809, random.nextDouble());
    }

    @ParameterizedTest
    @EnumSource
    void aKindTakesValuesFromItsLeastToItsGreatest(FaultKind kind) {
        for (double value : new double[] {kind.minValue(), kind.maxValue(), kind.defaultValue()}) {
            Fault fault = kind.createFault(value);
            assertEquals(kind, fault.kind());
            assertEquals(kind.takesValue() ? value : 0, fault.value());
            assertEquals(kind.takesLength() ? FaultKind.DEFAULT_LENGTH : 0, fault.length());
        }
        if (kind.takesValue()) {
            assertTrue(kind.minValue() < kind.defaultValue() && kind.defaultValue() < kind.maxValue());
            assertThrows(IllegalArgumentException.class, () -> kind.createFault(Math.nextDown(kind.minValue())));
            assertThrows(IllegalArgumentException.class, () -> kind.createFault(Math.nextUp(kind.maxValue())));
            assertThrows(IllegalArgumentException.class, () -> kind.createFault(Double.NaN));
        }
        assertEquals(kind.name().toLowerCase(Locale.ROOT).replace('_', '-'), kind.fileName());
    }

    /** A caller of the library may create the records without the kinds. */
    @ParameterizedTest
    @EnumSource
    void aFaultIsNeverOutsideTheLimitsOfItsKind(FaultKind kind) {
        Class<? extends Fault> type = kind.createFault(kind.defaultValue()).getClass();
        assertEquals(kind.takesValue(), type.getRecordComponents().length > 0, type.getName());
        double[] wrong = {
            Double.NaN,
            Double.NEGATIVE_INFINITY,
            Double.POSITIVE_INFINITY,
            Math.nextDown(kind.minValue()),
            Math.nextUp(kind.maxValue())
        };
        for (double value : kind.takesValue() ? wrong : new double[0]) {
            assertThrows(IllegalArgumentException.class, () -> create(type, value), type + " of " + value);
        }
    }

    /** Calls the canonical constructor of a fault, with the default for a length. */
    private static void create(Class<? extends Fault> type, double value) throws Throwable {
        boolean hasLength = type.getRecordComponents().length > 1;
        try {
            if (hasLength) {
                type.getDeclaredConstructor(double.class, double.class).newInstance(value, FaultKind.DEFAULT_LENGTH);
            } else {
                type.getDeclaredConstructor(double.class).newInstance(value);
            }
        } catch (InvocationTargetException e) {
            throw e.getCause();
        }
    }

    @Test
    void kindsSayWhatTheyTakeAndChange() {
        Set<FaultKind> optics = EnumSet.of(FaultKind.CONE, FaultKind.SPECULAR_LOSS, FaultKind.MISALIGNED);
        Set<FaultKind> withoutValue = EnumSet.of(FaultKind.OFF, FaultKind.STUCK_AT_LAST);
        for (FaultKind kind : FaultKind.values()) {
            assertEquals(optics.contains(kind), kind.changesOptics(), kind.name());
            assertEquals(withoutValue.contains(kind), !kind.takesValue(), kind.name());
            assertEquals(kind == FaultKind.BURSTS, kind.takesLength(), kind.name());
        }
        assertEquals(FaultKind.Family.SILENT, FaultKind.OFF.family());
        assertEquals(FaultKind.Family.INTERMITTENT, FaultKind.GHOST.family());
        assertEquals("m/s", FaultKind.DRIFT.unit());
        assertEquals(1, FaultKind.DRIFT.maxValue());
    }

    @Test
    void burstsHaveALengthWithinItsLimits() {
        assertEquals(
                FaultKind.MIN_LENGTH,
                FaultKind.BURSTS.createFault(1, FaultKind.MIN_LENGTH).length());
        assertEquals(
                FaultKind.MAX_LENGTH,
                FaultKind.BURSTS.createFault(1, FaultKind.MAX_LENGTH).length());
        assertThrows(IllegalArgumentException.class, () -> FaultKind.BURSTS.createFault(1, 0));
        assertThrows(IllegalArgumentException.class, () -> FaultKind.BURSTS.createFault(1, 1001));
    }

    @Test
    void aReadingIsADistanceNothingOrOff() {
        assertEquals(0.4, new Reading(0.4).distance().orElseThrow());
        assertTrue(new Reading(Reading.NOTHING).distance().isEmpty());
        assertTrue(new Reading(Reading.OFF).distance().isEmpty());
        assertTrue(new Reading(Reading.OFF).isOff());
        assertFalse(new Reading(Reading.NOTHING).isOff());
        assertFalse(new Reading(0).isOff());
        assertThrows(IllegalArgumentException.class, () -> new Reading(-1e-9));
    }
}
