package faultline.gui.dialog;

import faultline.engine.RunFailedException;
import faultline.external.ControllerChoice;
import faultline.external.PythonCommand;
import faultline.external.ShellWords;
import faultline.gui.document.ControllerSelection;
import faultline.gui.panel.FormDialog;
import faultline.gui.panel.NamedChoice;
import faultline.gui.text.ErrorMessages;
import faultline.gui.text.Messages;
import faultline.gui.text.TextWrap;
import faultline.gui.theme.UiText;
import faultline.io.MessageText;
import java.awt.BorderLayout;
import java.awt.Component;
import java.io.File;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import javax.swing.JButton;
import javax.swing.JComboBox;
import javax.swing.JFileChooser;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JTextArea;

/** Asks for a controller: the scenario's own, the name of one in Java, or a command. */
final class ControllerDialog {

    private static final String EXAMPLE = PythonCommand.text() + " \"my follower.py\"";
    private static final int GAP = 8;

    private final JComboBox<String> field = new JComboBox<>();
    private final List<Path> jars = new ArrayList<>();
    private final JTextArea help = UiText.wrappedText();
    private final String title;
    private final Path scenario;

    /** Creates a dialog with a title that shows a selection, given the open file, null for none. */
    ControllerDialog(String title, ControllerSelection now, Path scenario) {
        this.title = title;
        this.scenario = scenario;
        jars.addAll(now.jars());
        // Its lines are as long as its sentences.
        help.setLineWrap(false);
        help.setText(Messages.get("chooseController.help", EXAMPLE));
        field.setEditable(true);
        field.setRenderer(NamedChoice.rendererOf(ControllerDialog::nameOf));
        field.setPrototypeDisplayValue(EXAMPLE.repeat(2));
        // The text has the focus, not the combo box.
        for (Component part : List.of(field, field.getEditor().getEditorComponent())) {
            part.getAccessibleContext().setAccessibleName(Messages.get("chooseController.label"));
        }
        fillNames(now.isScenarios() ? Messages.get("chooseController.scenarios") : now.text());
    }

    /** Returns the names of all controllers; if a jar is broken, only those without jars, and shows the reason. */
    private List<String> names() {
        try {
            return loadNames();
        } catch (RunFailedException broken) {
            showProblem(broken);
            return ControllerChoice.names();
        }
    }

    private List<String> loadNames() {
        return ControllerChoice.withJars(jars, ControllerChoice::names);
    }

    private void showProblem(RunFailedException broken) {
        help.setText(TextWrap.wrap(ErrorMessages.describe(broken)));
    }

    private void fillNames(String selected) {
        field.removeAllItems();
        field.addItem(Messages.get("chooseController.scenarios"));
        names().forEach(field::addItem);
        field.setSelectedItem(selected);
    }

    /** Returns the name of a built-in controller with the text that chooses it, or only the text of another one. */
    static String nameOf(Object choice) {
        return switch (String.valueOf(choice)) {
            case ControllerChoice.WALL_FOLLOWER -> Messages.get("controller.kind.FOLLOWER") + " (" + choice + ")";
            case ControllerChoice.NONE -> Messages.get("controller.kind.NONE") + " (" + choice + ")";
            default -> String.valueOf(choice);
        };
    }

    /** Shows the dialog and waits for the answer; empty if cancelled. */
    Optional<ControllerSelection> showDialog(Component parent) {
        JPanel panel = createPanel();
        field.getEditor().selectAll();
        boolean accepted =
                FormDialog.showDialog(parent, title, panel, field.getEditor().getEditorComponent());
        return accepted ? Optional.of(selected()) : Optional.empty();
    }

    JPanel createPanel() {
        JPanel panel = new JPanel(new BorderLayout(GAP, GAP));
        JLabel label = new JLabel(Messages.get("chooseController.label"));
        label.setLabelFor(field);
        JButton browse = new JButton(Messages.get("chooseController.file"));
        browse.addActionListener(event -> chooseFile(panel));
        panel.add(label, BorderLayout.NORTH);
        panel.add(field, BorderLayout.CENTER);
        panel.add(browse, BorderLayout.LINE_END);
        panel.add(help, BorderLayout.SOUTH);
        return panel;
    }

    private ControllerSelection selected() {
        String text = text().strip();
        return new ControllerSelection(text.equals(Messages.get("chooseController.scenarios")) ? "" : text, jars);
    }

    private void chooseFile(Component parent) {
        JFileChooser chooser = FileDialogs.createChooser(startFolder());
        chooser.setDialogTitle(Messages.get("chooseController.file.title"));
        if (chooser.showOpenDialog(parent) == JFileChooser.APPROVE_OPTION) {
            useFile(chooser.getSelectedFile().toPath());
            // Enter then accepts the dialog instead of asking for a file again.
            field.getEditor().getEditorComponent().requestFocusInWindow();
        }
    }

    /**
     * Returns the folder of the file that the field names last, or else of the jar that was added last, or else of the
     * open scenario, or else the working directory.
     */
    File startFolder() {
        List<Path> named = ControllerChoice.files(selected().text());
        Path file = !named.isEmpty()
                ? named.get(named.size() - 1)
                : !jars.isEmpty() ? jars.get(jars.size() - 1) : scenario == null ? Path.of("scenario") : scenario;
        return file.toAbsolutePath().getParent().toFile();
    }

    /** Adds the controllers of a jar and selects its first, or makes the command that starts a program. */
    void useFile(Path file) {
        String name = file.getFileName().toString();
        help.setText(Messages.get("chooseController.help", EXAMPLE));
        if (!name.endsWith(".jar")) {
            String quoted = ShellWords.quoted(file.toString());
            field.setSelectedItem(name.endsWith(".py") ? PythonCommand.text() + " " + quoted : quoted);
            return;
        }
        jars.remove(file);
        List<String> before = names();
        jars.add(file);
        Optional<String> first = Optional.empty();
        try {
            first = loadNames().stream()
                    .filter(found -> !before.contains(found))
                    .findFirst();
            if (first.isEmpty()) {
                help.setText(Messages.get("chooseController.none", MessageText.excerpt(name)));
            }
        } catch (RunFailedException broken) {
            showProblem(broken);
        }
        if (first.isEmpty()) {
            jars.remove(file);
        }
        fillNames(first.orElse(text()));
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
