package faultline.gui.text;

import faultline.control.wallfollower.StateDiagram;

/** What the controllers' states and the conditions of their arrows are called. */
public final class StateText {

    private StateText() {}

    /**
     * A state in the user's language.
     *
     * @param state as the controller calls it
     * @return its name, or as the controller calls it where that is not known
     */
    public static String name(String state) {
        String key = "state." + state;
        return Messages.contains(key) ? Messages.get(key) : state;
    }

    /**
     * The condition of an arrow.
     *
     * @param arrow of the state diagram
     * @return in the user's language
     */
    public static String condition(StateDiagram.Arrow arrow) {
        return Messages.get("arrow." + arrow.from() + "." + arrow.to());
    }

    /**
     * The condition on a way from a state to a state.
     *
     * @param from a state as the controller calls it
     * @param to another
     * @param condition as the controller calls it
     * @return in the user's language, or as the controller calls it where that is not known
     */
    public static String condition(String from, String to, String condition) {
        String key = "arrow." + from + "." + to;
        return Messages.contains(key) ? Messages.get(key) : condition;
    }
}
