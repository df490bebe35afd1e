package faultline.external;

import faultline.control.ControllerState;
import faultline.control.Decision;
import faultline.control.Telemetry;
import faultline.io.XmlText;

/** Tracks the states that an external controller reports, so that they are shown like those of the built-in one. */
final class DriveTelemetry {

    private Telemetry telemetry;
    /** The state as the controller wrote it; empty before the first one. */
    private String lastState = "";

    /** Begins in a state with a given name. */
    DriveTelemetry(String initialState) {
        telemetry = Telemetry.ofState(ControllerState.of(initialState));
    }

    /** Returns the decision of a drive message; a message without a state, or with blanks only, keeps the last one. */
    Decision decide(DriveMessage drive, long tick) {
        if (!drive.state().isEmpty() && !drive.state().equals(lastState)) {
            lastState = drive.state();
            String state = XmlText.oneLine(lastState);
            telemetry = state.isEmpty() ? telemetry : telemetry.entering(state, XmlText.oneLine(drive.why()), tick);
        }
        return new Decision(drive.leftVolts(), drive.rightVolts(), telemetry);
    }
}
