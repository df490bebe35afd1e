package faultline.gui.action;

import java.util.Collection;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.Map;

/** The actions of a window by key, in the order in which they were added. */
public final class ActionRegistry {

    private final Map<String, UiAction> actions = new LinkedHashMap<>();

    public UiAction add(UiAction action) {
        if (actions.put(action.key(), action) != null) {
            throw new IllegalArgumentException("two actions are called " + action.key());
        }
        return action;
    }

    public UiAction get(String key) {
        UiAction action = actions.get(key);
        if (action == null) {
            throw new IllegalArgumentException("there is no action " + key);
        }
        return action;
    }

    public Collection<UiAction> allActions() {
        return Collections.unmodifiableCollection(actions.values());
    }
}
