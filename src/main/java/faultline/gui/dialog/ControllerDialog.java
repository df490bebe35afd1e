package faultline.gui.dialog;

import faultline.external.CommandWords;
import faultline.external.ControllerChoice;
import faultline.gui.text.Messages;
import java.awt.BorderLayout;
import java.awt.Component;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import javax.swing.JButton;
import javax.swing.JComboBox;
import javax.swing.JDialog;
import javax.swing.JFileChooser;
import javax.swing.JLabel;
import javax.swing.JOptionPane;
import javax.swing.JPanel;

/** Asks for a controller: the scenario's own, the name of one in Java, or a command. */
final class ControllerDialog {

    private static final String EXAMPLE = "python3 \"my follower.py\"";
    private static final int GAP = 8;

    private final JComboBox<String> field = new JComboBox<>();
    private final List<Path> jars = new ArrayList<>();

    /**
     * What the user has chosen.
     *
     * @param text a name or a command, empty for the scenario's own controller
     * @param jars files with controllers in Java
     */
    record Choice(String text, List<Path> jars) {

        /** The controller that the scenario names. */
        static final Choice SCENARIO = new Choice("", List.of());

        Choice {
            jars = List.copyOf(jars);
        }

        boolean isScenarios() {
            return text.isEmpty();
        }

        /** Returns the files that the controller consists of, as far as the choice names them. */
        List<Path> files() {
            return Stream.concat(jars.stream(), words().flatMap(Choice::file)).toList();
        }

        private Stream<String> words() {
            try {
                return CommandWords.split(text).stream();
            } catch (IllegalArgumentException unfinished) {
                return Stream.empty();
            }
        }

        private static Stream<Path> file(String word) {
            try {
                return Stream.of(Path.of(word)).filter(Files::isRegularFile);
            } catch (InvalidPathException noPath) {
                return Stream.empty();
            }
        }
    }

    /** Creates a dialog that shows a choice. */
    ControllerDialog(Choice now) {
        jars.addAll(now.jars());
        field.setEditable(true);
        field.setPrototypeDisplayValue(EXAMPLE.repeat(2));
        field.getAccessibleContext().setAccessibleName(Messages.get("chooseController.label"));
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
    Optional<Choice> showDialog(Component parent) {
        JPanel panel = new JPanel(new BorderLayout(GAP, GAP));
        JLabel label = new JLabel(Messages.get("chooseController.label"));
        label.setLabelFor(field);
        JButton browse = new JButton(Messages.get("chooseController.file"));
        browse.addActionListener(event -> chooseFile(panel));
        panel.add(label, BorderLayout.NORTH);
        panel.add(field, BorderLayout.CENTER);
        panel.add(browse, BorderLayout.LINE_END);
        panel.add(new JLabel(Messages.get("chooseController.help", EXAMPLE)), BorderLayout.SOUTH);
        // The field has the focus initially.
        JOptionPane pane = new JOptionPane(panel, JOptionPane.PLAIN_MESSAGE, JOptionPane.OK_CANCEL_OPTION) {
            @Override
            public void selectInitialValue() {
                super.selectInitialValue();
                field.getEditor().getEditorComponent().requestFocusInWindow();
                field.getEditor().selectAll();
            }
        };
        JDialog dialog = pane.createDialog(parent, Messages.get("chooseController.title"));
        dialog.setVisible(true);
        dialog.dispose();
        return Integer.valueOf(JOptionPane.OK_OPTION).equals(pane.getValue())
                ? Optional.of(selected())
                : Optional.empty();
    }

    private Choice selected() {
        String text = String.valueOf(field.getEditor().getItem()).strip();
        return new Choice(text.equals(Messages.get("chooseController.scenarios")) ? "" : text, jars);
    }

    private void chooseFile(Component parent) {
        JFileChooser chooser = new JFileChooser();
        if (chooser.showOpenDialog(parent) == JFileChooser.APPROVE_OPTION) {
            useFile(chooser.getSelectedFile().toPath());
        }
    }

    /** Adds the controllers of a jar, or makes the command that starts a program. */
    void useFile(Path file) {
        String name = file.getFileName().toString();
        if (!name.endsWith(".jar")) {
            String quoted = "\"" + file + "\"";
            field.setSelectedItem(name.endsWith(".py") ? "python3 " + quoted : quoted);
            return;
        }
        List<String> before = names();
        jars.remove(file);
        jars.add(file);
        fillNames(names().stream()
                .filter(found -> !before.contains(found))
                .findFirst()
                .orElse(String.valueOf(field.getEditor().getItem())));
    }
}
