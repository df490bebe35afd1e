package faultline.gui.panel;

import faultline.gui.text.Messages;
import faultline.sensor.FaultKind;

/** The names of fault kinds. */
public final class FaultNames {

    private FaultNames() {}

    /** Returns the name of a kind in the user's language. */
    public static String nameOf(FaultKind kind) {
        return Messages.get("fault." + kind.fileName());
    }
}
