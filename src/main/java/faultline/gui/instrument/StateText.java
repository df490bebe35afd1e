package faultline.gui.instrument;

import faultline.control.StateDiagram;
import faultline.gui.text.Texts;

/** What the controllers' states and the conditions of their arrows are called. */
final class StateText {

    private StateText() {
    }

    /** A state in the user's language, or as the controller calls it where that is not known. */
    static String name(String state) {
        String key = "state." + state;
        return Texts.has(key) ? Texts.text(key) : state;
    }

    /** The condition of an arrow. */
    static String condition(StateDiagram.Arrow arrow) {
        return Texts.text("arrow." + arrow.from() + "." + arrow.to());
    }

    /** The condition on a way from a state to a state, or as the controller calls it where that is not known. */
    static String condition(String from, String to, String condition) {
        String key = "arrow." + from + "." + to;
        return Texts.has(key) ? Texts.text(key) : condition;
    }
}
