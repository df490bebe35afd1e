package faultline.gui.panel;

import faultline.gui.text.Texts;
import faultline.sensor.FaultKind;

/** What kinds of fault are called. */
final class FaultNames {

    private FaultNames() {
    }

    /** The kind in the user's language. */
    static String of(FaultKind kind) {
        return Texts.text("fault." + kind.fileName());
    }
}
