package faultline.gui.window;

import faultline.gui.edit.UndoController;
import faultline.gui.theme.UiText;
import faultline.world.Command;
import faultline.world.SensorSnapshot;
import java.util.function.Consumer;
import javax.swing.JMenuItem;
import javax.swing.JPopupMenu;

/** The items of a context menu that concern one sensor: it is switched, gets a fault or is repaired. */
final class SensorMenu {

    private final JPopupMenu popup;
    private final String id;

    private SensorMenu(JPopupMenu popup, String id) {
        this.popup = popup;
        this.id = id;
    }

    /** Adds the items to a menu; {@code newFault} receives the id of a sensor for which it asks for a fault. */
    static void addTo(JPopupMenu popup, SensorSnapshot sensor, UndoController editor, Consumer<String> newFault) {
        String id = sensor.spec().id();
        boolean on = sensor.spec().on();
        SensorMenu menu = new SensorMenu(popup, id);
        menu.add(on ? "sensorMenu.off" : "sensorMenu.on", () -> editor.send(new Command.SwitchSensor(id, !on)));
        menu.add("sensorMenu.fault", () -> newFault.accept(id));
        menu.add("sensorMenu.repair", () -> editor.send(new Command.ClearFaults(id)))
                .setEnabled(!sensor.faults().isEmpty());
        popup.addSeparator();
    }

    private JMenuItem add(String key, Runnable action) {
        JMenuItem item = popup.add(UiText.menuText(new JMenuItem(), key, id));
        item.addActionListener(event -> action.run());
        return item;
    }
}
