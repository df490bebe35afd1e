package faultline.gui.window;

import faultline.gui.text.Texts;
import java.awt.Component;
import java.io.File;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Locale;
import java.util.Optional;
import java.util.stream.Stream;
import javax.swing.JComponent;
import javax.swing.JDialog;
import javax.swing.JFileChooser;
import javax.swing.JOptionPane;
import javax.swing.KeyStroke;
import javax.swing.filechooser.FileNameExtensionFilter;

/** Asks which file. */
final class FileQuestions {

    private final Component parent;
    private File folder = new File("").getAbsoluteFile();

    FileQuestions(Component parent) {
        this.parent = parent;
    }

    /** The file to open, empty where the user thinks better of it. */
    Optional<Path> fileToOpen(String action, Optional<Path> open) {
        JFileChooser chooser = chooser(action, "xml");
        open.map(Path::toAbsolutePath).map(Path::toFile).ifPresent(chooser::setSelectedFile);
        return answer(chooser, chooser.showOpenDialog(parent));
    }

    /** The file to write, of the suggestion's kind; empty where the user thinks better of it; asks before a file is replaced. */
    Optional<Path> fileToSave(String action, Path suggestion) {
        String name = suggestion.getFileName().toString();
        String extension = name.substring(name.lastIndexOf('.') + 1);
        JFileChooser chooser = chooser(action, extension);
        chooser.setSelectedFile(new File(folder, name));
        if (suggestion.isAbsolute()) {
            chooser.setSelectedFile(suggestion.toFile());
        }
        return answer(chooser, chooser.showSaveDialog(parent)).map(file -> withExtension(file, extension)).filter(this::mayReplace);
    }

    private JFileChooser chooser(String action, String extension) {
        JFileChooser chooser = new Chooser(folder);
        chooser.setDialogTitle(Texts.text("files." + action));
        chooser.setFileFilter(new FileNameExtensionFilter(Texts.text("files.filter." + extension), extension));
        return chooser;
    }

    private Optional<Path> answer(JFileChooser chooser, int answer) {
        if (answer != JFileChooser.APPROVE_OPTION) {
            return Optional.empty();
        }
        folder = chooser.getCurrentDirectory();
        return Optional.of(chooser.getSelectedFile().toPath());
    }

    /** The file, with the extension behind its name unless it is there. */
    static Path withExtension(Path file, String extension) {
        String name = file.getFileName().toString();
        boolean has = name.toLowerCase(Locale.ROOT).endsWith("." + extension);
        return has ? file : file.resolveSibling(name + "." + extension);
    }

    /** A file dialog that Escape closes wherever in it the focus is. */
    private static final class Chooser extends JFileChooser {
        Chooser(File folder) {
            super(folder);
        }

        @Override
        protected JDialog createDialog(Component parent) {
            JDialog dialog = super.createDialog(parent);
            dialog.getRootPane().registerKeyboardAction(event -> cancelSelection(), KeyStroke.getKeyStroke("ESCAPE"), JComponent.WHEN_IN_FOCUSED_WINDOW);
            return dialog;
        }
    }

    /**
     * Asks a question; says which of the answers, given by their keys, was chosen, the first being what Enter chooses: negative where the
     * question was closed.
     */
    int choose(String key, String question, String... answerKeys) {
        String[] answers = Stream.of(answerKeys).map(Texts::text).toArray(String[]::new);
        return JOptionPane.showOptionDialog(parent, Lines.broken(question), Texts.text(key + ".title"), JOptionPane.DEFAULT_OPTION,
                JOptionPane.QUESTION_MESSAGE,
                null, answers, answers[0]);
    }

    private boolean mayReplace(Path file) {
        if (!Files.exists(file)) {
            return true;
        }
        String question = Texts.text("files.replace", file.getFileName().toString());
        return JOptionPane.showConfirmDialog(parent, Lines.broken(question), Texts.text("files.replace.title"), JOptionPane.OK_CANCEL_OPTION,
                JOptionPane.WARNING_MESSAGE) == JOptionPane.OK_OPTION;
    }
}
