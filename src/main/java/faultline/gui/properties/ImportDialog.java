package faultline.gui.properties;

import faultline.gui.text.Messages;
import faultline.scenario.Scenario;
import java.awt.Component;
import java.nio.file.Path;
import java.util.Optional;
import javax.swing.JOptionPane;

/** Makes a scenario of a floor plan, with a preview. */
public final class ImportDialog {

    private ImportDialog() {}

    /** Shows the dialog and returns the scenario; empty if cancelled. */
    public static Optional<Scenario> showDialog(Component parent, Path file) {
        ImportForm form = new ImportForm(file);
        String title = Messages.get("import.title", String.valueOf(file.getFileName()));
        while (JOptionPane.showConfirmDialog(
                        parent, form, title, JOptionPane.OK_CANCEL_OPTION, JOptionPane.PLAIN_MESSAGE)
                == JOptionPane.OK_OPTION) {
            if (form.scenario().isPresent()) {
                return form.scenario();
            }
            JOptionPane.showMessageDialog(parent, form.status(), title, JOptionPane.WARNING_MESSAGE);
        }
        return Optional.empty();
    }
}
