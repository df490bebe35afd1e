package faultline.gui.dialog;

import faultline.external.ControllerChoice;
import faultline.gui.document.ControllerSelection;
import faultline.gui.panel.FormDialog;
import faultline.gui.text.Messages;
import faultline.io.MessageText;
import java.awt.BorderLayout;
import java.awt.Component;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import javax.swing.JButton;
import javax.swing.JComboBox;
import javax.swing.JFileChooser;
import javax.swing.JLabel;
import javax.swing.JPanel;

/** Asks for a controller: the scenario's own, the name of one in Java, or a command. */
final class ControllerDialog {

    private static final String EXAMPLE = "python3 \"my follower.py\"";
    private static final int GAP = 8;

    private final JComboBox<String> field = new JComboBox<>();
    private final List<Path> jars = new ArrayList<>();
    private final JLabel help = new JLabel(Messages.get("chooseController.help", EXAMPLE));
    private final String title;

    /** Creates a dialog with a title that shows a selection. */
    ControllerDialog(String title, ControllerSelection now) {
        this.title = title;
        jars.addAll(now.jars());
        field.setEditable(true);
        field.setPrototypeDisplayValue(EXAMPLE.repeat(2));
        // The text has the focus, not the combo box.
        for (Component part : List.of(field, field.getEditor().getEditorComponent())) {
            part.getAccessibleContext().setAccessibleName(Messages.get("chooseController.label"));
        }
        fillNames(now.isScenarios() ? Messages.get("chooseController.scenarios") : now.text());
    }

    private List<String> names() {
        return ControllerChoice.withJars(jars, ControllerChoice::names);
    }

    private void fillNames(String selected) {
        field.removeAllItems();
        field.addItem(Messages.get("chooseController.scenarios"));
        names().forEach(field::addItem);
        field.setSelectedItem(selected);
    }

    /** Shows the dialog and waits for the answer; empty if cancelled. */
    Optional<ControllerSelection> showDialog(Component parent) {
        JPanel panel = new JPanel(new BorderLayout(GAP, GAP));
        JLabel label = new JLabel(Messages.get("chooseController.label"));
        label.setLabelFor(field);
        JButton browse = new JButton(Messages.get("chooseController.file"));
        browse.addActionListener(event -> chooseFile(panel));
        panel.add(label, BorderLayout.NORTH);
        panel.add(field, BorderLayout.CENTER);
        panel.add(browse, BorderLayout.LINE_END);
        panel.add(help, BorderLayout.SOUTH);
        field.getEditor().selectAll();
        boolean accepted =
                FormDialog.showDialog(parent, title, panel, field.getEditor().getEditorComponent());
        return accepted ? Optional.of(selected()) : Optional.empty();
    }

    private ControllerSelection selected() {
        String text = text().strip();
        return new ControllerSelection(text.equals(Messages.get("chooseController.scenarios")) ? "" : text, jars);
    }

    private void chooseFile(Component parent) {
        JFileChooser chooser = new JFileChooser();
        if (chooser.showOpenDialog(parent) == JFileChooser.APPROVE_OPTION) {
            useFile(chooser.getSelectedFile().toPath());
            // Enter then accepts the dialog instead of asking for a file again.
            field.getEditor().getEditorComponent().requestFocusInWindow();
        }
    }

    /** Adds the controllers of a jar and selects its first, or makes the command that starts a program. */
    void useFile(Path file) {
        String name = file.getFileName().toString();
        help.setText(Messages.get("chooseController.help", EXAMPLE));
        if (!name.endsWith(".jar")) {
            String quoted = "\"" + file + "\"";
            field.setSelectedItem(name.endsWith(".py") ? "python3 " + quoted : quoted);
            return;
        }
        jars.remove(file);
        List<String> before = names();
        jars.add(file);
        Optional<String> first =
                names().stream().filter(found -> !before.contains(found)).findFirst();
        if (first.isEmpty()) {
            jars.remove(file);
            help.setText(Messages.get("chooseController.none", MessageText.excerpt(name)));
        }
        fillNames(first.orElse(String.valueOf(field.getEditor().getItem())));
    }

    /** Returns the text below the field: an example, or what is wrong with the chosen file. */
    String help() {
        return help.getText();
    }

    /** Returns the name or the command in the field. */
    String text() {
        return String.valueOf(field.getEditor().getItem());
    }
}
