package faultline.gui.panel;

import faultline.gui.text.Messages;
import faultline.sensor.FaultKind;

/** What kinds of fault are called. */
final class FaultNames {

    private FaultNames() {}

    /** The kind in the user's language. */
    static String nameOf(FaultKind kind) {
        return Messages.get("fault." + kind.fileName());
    }
}
