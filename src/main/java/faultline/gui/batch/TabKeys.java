package faultline.gui.batch;

import java.util.List;
import javax.swing.JComponent;
import javax.swing.KeyStroke;

/** The keys that switch tabs, which tables and scroll panes would use otherwise. */
final class TabKeys {

    private static final List<String> KEYS = List.of("ctrl PAGE_UP", "ctrl PAGE_DOWN");

    private TabKeys() {}

    /** Lets a component ignore the keys, so that the tabbed pane around it receives them. */
    static void leaveToTabs(JComponent component) {
        KEYS.forEach(key -> component
                .getInputMap(JComponent.WHEN_ANCESTOR_OF_FOCUSED_COMPONENT)
                .put(KeyStroke.getKeyStroke(key), "none"));
    }
}
