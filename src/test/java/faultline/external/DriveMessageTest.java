package faultline.external;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import faultline.robot.RobotSpec;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Velocities of the robot as voltages: its track is 0.18 m, and a motor drives 0.1 m/s for each volt. */
class DriveMessageTest {

    private static DriveMessage read(String members) throws ProtocolException {
        return DriveMessage.read(MessageReader.of("{" + members + "}"), RobotSpec.DEFAULT);
    }

    /** A positive angular velocity turns the robot to the left, so its right wheels are faster. */
    @ParameterizedTest
    @CsvSource({"0.2, 0, 2, 2", "0, 1, -0.9, 0.9", "0.2, -1, 2.9, 1.1"})
    void velocitiesAreConvertedByTheTrackAndTheMotors(double v, double omega, double left, double right)
            throws ProtocolException {
        DriveMessage drive = read("\"v_m_s\":" + v + ",\"omega_rad_s\":" + omega);
        assertEquals(left, drive.leftVolts(), 1e-12);
        assertEquals(right, drive.rightVolts(), 1e-12);
    }

    @Test
    void bothVelocitiesAreNeeded() {
        for (String one : new String[] {"v_m_s", "omega_rad_s"}) {
            ProtocolException e = assertThrows(ProtocolException.class, () -> read("\"" + one + "\":1"));
            String other = one.equals("v_m_s") ? "omega_rad_s" : "v_m_s";
            assertEquals(
                    "wrote a message whose \"" + other + "\" is missing; expected a finite number", e.getMessage());
        }
    }

    /** The wheels of one side are too fast if the turn adds to the speed, and slow if it is subtracted. */
    @ParameterizedTest
    @CsvSource({"1e307, 1e308", "1e307, -1e308"})
    void aVelocityThatIsTooLargeForOneSideIsRejected(String v, String omega) {
        ProtocolException e =
                assertThrows(ProtocolException.class, () -> read("\"v_m_s\":" + v + ",\"omega_rad_s\":" + omega));
        assertEquals("wrote a drive message whose velocities are too large for any voltage", e.getMessage());
    }
}
