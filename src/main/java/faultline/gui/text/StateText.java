package faultline.gui.text;

import faultline.control.ControllerState;
import faultline.control.wallfollower.StateDiagram;

/** The names of controller states and transition conditions. */
public final class StateText {

    private StateText() {}

    /** Returns the name of a state in the user's language, or the controller's name for it if there is none. */
    public static String name(ControllerState state) {
        String key = "state." + state;
        return Messages.contains(key) ? Messages.get(key) : state.name();
    }

    /** Describes a transition by its states and, if it has any, its condition. */
    public static String transition(ControllerState from, ControllerState to, String condition) {
        String shown = condition(from, to, condition);
        return shown.isEmpty()
                ? Messages.get("diagram.change", name(from), name(to))
                : Messages.get("diagram.last", name(from), name(to), shown);
    }

    /**
     * Returns the condition of a transition in the user's language if it is the wall follower's for these states, or
     * one that stops it; otherwise the controller's own text.
     */
    public static String condition(ControllerState from, ControllerState to, String condition) {
        boolean isFollowers = StateDiagram.TRANSITIONS.stream()
                .anyMatch(arrow -> arrow.from().equals(from)
                        && arrow.to().equals(to)
                        && arrow.condition().equals(condition));
        if (isFollowers) {
            return Messages.get("arrow." + from + "." + to);
        }
        String named = "condition." + condition.replace(' ', '.');
        return Messages.contains(named) ? Messages.get(named) : condition;
    }
}
