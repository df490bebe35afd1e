package faultline.gui.dialog;

import faultline.external.ControllerChoice;
import faultline.external.ControllerNames;
import faultline.external.PythonCommand;
import faultline.external.ShellWords;
import faultline.gui.document.BackgroundTasks;
import faultline.gui.form.FormDialog;
import faultline.gui.form.NamedChoice;
import faultline.gui.text.ErrorMessages;
import faultline.gui.text.Messages;
import faultline.gui.text.TextListener;
import faultline.gui.text.TextWrap;
import faultline.gui.theme.UiText;
import faultline.io.MessageText;
import java.awt.BorderLayout;
import java.awt.Component;
import java.io.File;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.Callable;
import java.util.function.Consumer;
import java.util.stream.IntStream;
import javax.swing.DefaultComboBoxModel;
import javax.swing.JButton;
import javax.swing.JComboBox;
import javax.swing.JFileChooser;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JRootPane;
import javax.swing.JTextArea;
import javax.swing.SwingUtilities;
import javax.swing.text.JTextComponent;

/** Asks for a controller: the scenario's own, the name of one in Java, or a command. */
final class ControllerDialog {

    private static final String EXAMPLE = PythonCommand.text() + " \"my follower.py\"";
    private static final int GAP = 8;
    private static final int HELP_ROWS = 2;

    private final JComboBox<String> field = new JComboBox<>();
    private final JTextArea help = UiText.wrappedText();
    /** The prefix of the keys of its title and of the help. */
    private final String key;

    private final Path scenario;
    /** The commands that were used last, the newest first. */
    private final List<String> recent;

    private List<Path> jars;
    /** The number of times that names have been loaded; only the last ones are shown. */
    private int loads;
    /**
     * The jar whose controller is selected when it has been loaded, null for none or if the user no longer wants it.
     */
    private Path awaited;

    /**
     * Creates a dialog that shows a selection, given the open file, null for none, and the commands used last. The key
     * is {@code chooseController} for the controller of the run or {@code compareController} for that of a ghost.
     */
    ControllerDialog(String key, ControllerChoice now, Path scenario, List<String> recent) {
        this.key = key;
        this.scenario = scenario;
        this.recent = recent;
        this.jars = now.jars();
        // Its lines are as long as its sentences.
        help.setLineWrap(false);
        help.setRows(HELP_ROWS);
        showExample();
        field.setEditable(true);
        // A command may be wider than the list.
        field.setRenderer(NamedChoice.rendererOf(ControllerDialog::nameOf, this::tipOf));
        field.setPrototypeDisplayValue(EXAMPLE.repeat(2));
        // The text has the focus, not the combo box.
        for (Component part : List.of(field, field.getEditor().getEditorComponent())) {
            part.getAccessibleContext().setAccessibleName(Messages.get("chooseController.label"));
        }
        field.addItem(Messages.get("chooseController.scenarios"));
        ((JTextComponent) field.getEditor().getEditorComponent())
                .getDocument()
                .addDocumentListener(new TextListener(this::stopAwaiting));
        field.setSelectedItem(now.isScenarioDefault() ? Messages.get("chooseController.scenarios") : now.text());
        load(() -> FoundControllers.of(now.jars()), found -> showNames(found, text()));
    }

    /** Loads names on another thread, because the code of a jar may take any time, and shows them. */
    private void load(Callable<FoundControllers> names, Consumer<FoundControllers> onLoaded) {
        int number = ++loads;
        BackgroundTasks.compute(
                names,
                found -> {
                    if (number == loads) {
                        onLoaded.accept(found);
                    }
                },
                failure -> {
                    if (number == loads) {
                        await(null);
                        showProblem(failure);
                    }
                });
    }

    /** Awaits a jar, null for none. The dialog cannot be accepted before, because it does not show the choice yet. */
    private void await(Path jar) {
        awaited = jar;
        JRootPane root = SwingUtilities.getRootPane(field);
        if (root != null && root.getDefaultButton() != null) {
            root.getDefaultButton().setEnabled(jar == null);
        }
    }

    /** Stops awaiting a jar when the user enters something else. */
    private void stopAwaiting() {
        if (awaited != null) {
            await(null);
            showExample();
        }
    }

    private void showExample() {
        help.setText(Messages.get(key + ".help", EXAMPLE));
    }

    private void showNames(FoundControllers found, String selected) {
        DefaultComboBoxModel<String> model = new DefaultComboBoxModel<>();
        model.addElement(Messages.get("chooseController.scenarios"));
        model.addAll(found.names());
        model.addAll(recent.stream()
                .filter(command -> !found.names().contains(command))
                .toList());
        model.setSelectedItem(selected);
        field.setModel(model);
        if (found.problem() != null) {
            showProblem(found.problem());
        }
    }

    private void showProblem(Throwable problem) {
        help.setText(TextWrap.wrap(ErrorMessages.describe(problem)));
    }

    /** Returns the name of a built-in controller with the text that chooses it, or only the text of another one. */
    static String nameOf(Object choice) {
        return switch (String.valueOf(choice)) {
            case ControllerNames.WALL_FOLLOWER -> Messages.get("controller.kind.FOLLOWER") + " (" + choice + ")";
            case ControllerNames.NONE -> Messages.get("controller.kind.NONE") + " (" + choice + ")";
            default -> String.valueOf(choice);
        };
    }

    private String tipOf(String choice) {
        return recent.contains(choice) ? choice : null;
    }

    /** Shows the dialog and waits for the answer; empty if cancelled. */
    Optional<ControllerChoice> showDialog(Component parent) {
        JPanel panel = createPanel();
        field.getEditor().selectAll();
        boolean accepted = FormDialog.showDialog(
                parent, Messages.get(key + ".title"), panel, field.getEditor().getEditorComponent());
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

    private ControllerChoice selected() {
        String text = text().strip();
        return new ControllerChoice(text.equals(Messages.get("chooseController.scenarios")) ? "" : text, jars);
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
        List<Path> named = selected().files();
        Path file = !named.isEmpty() ? named.get(named.size() - 1) : scenario == null ? Path.of("scenario") : scenario;
        return file.toAbsolutePath().getParent().toFile();
    }

    /**
     * Adds the controllers of a jar and selects its first as soon as they have been loaded, or makes the command that
     * starts a program.
     */
    void useFile(Path file) {
        String name = file.getFileName().toString();
        if (!name.endsWith(".jar")) {
            await(null);
            showExample();
            String quoted = ShellWords.quoted(file.toString());
            field.setSelectedItem(name.endsWith(".py") ? PythonCommand.text() + " " + quoted : quoted);
            return;
        }
        await(file);
        help.setText(Messages.get("chooseController.loading", MessageText.excerpt(name)));
        List<Path> others = jars;
        load(() -> FoundControllers.of(others, file), found -> showJar(found, file));
    }

    private void showJar(FoundControllers found, Path file) {
        jars = found.jars();
        boolean wanted = file.equals(awaited);
        if (wanted) {
            await(null);
            if (found.first() == null) {
                help.setText(Messages.get(
                        "chooseController.none",
                        MessageText.excerpt(file.getFileName().toString())));
            } else {
                showExample();
            }
        }
        showNames(found, wanted && found.first() != null ? found.first() : text());
    }

    /** Returns the text below the field: an example, or what is wrong with the chosen file. */
    String help() {
        return help.getText();
    }

    /** Returns the jars with controllers that the user has added. */
    List<Path> jars() {
        return jars;
    }

    /** Returns the entries of the list. */
    List<String> names() {
        return IntStream.range(0, field.getItemCount())
                .mapToObj(field::getItemAt)
                .toList();
    }

    /** Returns the name or the command in the field. */
    String text() {
        return String.valueOf(field.getEditor().getItem());
    }
}
