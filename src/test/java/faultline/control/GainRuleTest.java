package faultline.control;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;

class GainRuleTest {

    private final SplittableRandom random = new SplittableRandom(41);

    /** The loop e'' + k_d v e' + k_p v e = 0 has one root twice if its discriminant is zero. */
    private static void assertCriticallyDamped(PdGains gains, double speed) {
        double damping = gains.derivative() * speed;
        assertEquals(1, damping * damping / (4 * gains.proportional() * speed), 1e-12);
    }

    @Test
    void aLengthGivesALoopThatIsCriticallyDampedAtAnySpeed() {
        for (int i = 0; i < 100; i++) {
            double speed = random.nextDouble(0.01, 2);
            double length = random.nextDouble(0.01, 1);
            PdGains gains = new GainRule.Length(length).gains(speed, random.nextDouble(1));
            assertCriticallyDamped(gains, speed);
            assertEquals(
                    speed / length, gains.derivative() * speed / 2, 1e-12, "its root is the speed over the length");
        }
    }

    @Test
    void theAutomaticLengthGrowsWithTheLagButHasALeast() {
        for (double speed : new double[] {0.1, 0.3, 1}) {
            assertEquals(new GainRule.Length(0.06).gains(speed, 0), GainRule.AUTOMATIC.gains(speed, 0));
            assertEquals(new GainRule.Length(3 * 0.5 * speed).gains(speed, 0.5), GainRule.AUTOMATIC.gains(speed, 0.5));
            assertEquals(GainRule.AUTOMATIC.gains(speed, 0.1), PdGains.forSpeed(speed, 0.1));
        }
    }

    @Test
    void givenGainsAreKept() {
        PdGains gains = new GainRule.Fixed(7, 11).gains(0.3, 0.05);
        assertEquals(7, gains.proportional());
        assertEquals(11, gains.derivative());
    }

    @Test
    void theGreatestErrorLeadsToTheWallAtThirtyDegreesByAnyRule() {
        for (int i = 0; i < 100; i++) {
            double speed = random.nextDouble(0.01, 2);
            for (GainRule rule : new GainRule[] {
                GainRule.AUTOMATIC,
                new GainRule.Length(random.nextDouble(0.01, 1)),
                new GainRule.Fixed(random.nextDouble(1, 50), random.nextDouble(1, 50))
            }) {
                PdGains gains = rule.gains(speed, 0.05);
                // The terms cancel where the error shrinks at speed times the sine of 30 degrees.
                for (double error : new double[] {gains.maxError(), 2 * gains.maxError(), 100}) {
                    assertEquals(0, gains.proportionalTerm(error) + gains.derivativeTerm(-speed / 2), 1e-9);
                    assertEquals(0, gains.proportionalTerm(-error) + gains.derivativeTerm(speed / 2), 1e-9);
                }
                assertEquals(
                        gains.proportional() * 0.9 * gains.maxError(),
                        gains.proportionalTerm(0.9 * gains.maxError()),
                        1e-12);
            }
        }
    }

    @Test
    void lengthsAndGainsArePositiveAndFinite() {
        for (double wrong : new double[] {0, -1, Double.NaN, Double.POSITIVE_INFINITY}) {
            assertThrows(IllegalArgumentException.class, () -> new GainRule.Length(wrong));
            assertThrows(IllegalArgumentException.class, () -> new GainRule.Fixed(wrong, 1));
            assertThrows(IllegalArgumentException.class, () -> new GainRule.Fixed(1, wrong));
        }
    }

    @Test
    void eachKindOfRuleIsMatchedByItsOwnCase() {
        GainRule.GainCases<String> cases = new GainRule.GainCases<>(
                automatic -> "automatic",
                length -> "length " + length.metres(),
                fixed -> "fixed " + fixed.proportional() + " " + fixed.derivative());
        assertEquals("automatic", GainRule.AUTOMATIC.match(cases));
        assertEquals("length 0.5", new GainRule.Length(0.5).match(cases));
        assertEquals("fixed 7.0 11.0", new GainRule.Fixed(7, 11).match(cases));
    }
}
