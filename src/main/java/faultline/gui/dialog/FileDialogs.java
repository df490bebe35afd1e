package faultline.gui.dialog;

import faultline.gui.document.FileNames;
import faultline.gui.properties.FloorPlanFiles;
import faultline.gui.text.Messages;
import faultline.gui.text.TextWrap;
import faultline.gui.theme.EmptyToolTips;
import faultline.gui.theme.ScreenFit;
import java.awt.Component;
import java.awt.event.ActionEvent;
import java.io.File;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.function.UnaryOperator;
import java.util.regex.Pattern;
import javax.swing.AbstractAction;
import javax.swing.Action;
import javax.swing.JComponent;
import javax.swing.JDialog;
import javax.swing.JFileChooser;
import javax.swing.JOptionPane;
import javax.swing.KeyStroke;
import javax.swing.Timer;
import javax.swing.filechooser.FileNameExtensionFilter;
import javax.swing.plaf.metal.MetalFileChooserUI;

/** File choosers and option dialogs. */
class FileDialogs {

    private static final int LOADING_DELAY_MILLIS = 1000;
    private static final Pattern PATTERN_CHARACTERS = Pattern.compile("[*?\\[]");

    private final Component parent;
    private File folder = new File("").getAbsoluteFile();

    FileDialogs(Component parent) {
        this.parent = parent;
        loadClasses();
    }

    /** Creates a file chooser soon after the start, so that the first dialog opens fast. */
    private void loadClasses() {
        Timer timer = new Timer(LOADING_DELAY_MILLIS, event -> new EscapableFileChooser(folder));
        timer.setRepeats(false);
        timer.start();
    }

    /** Asks for a file to open, given the initially selected one, null for none; empty if cancelled. */
    Optional<Path> chooseFileToOpen(String action, Path selected) {
        JFileChooser chooser = createChooser(action, "xml");
        if (selected != null) {
            chooser.setSelectedFile(selected.toAbsolutePath().toFile());
        }
        return selectedFile(chooser, chooser.showOpenDialog(parent));
    }

    /** Asks for a floor plan to import; empty if cancelled. */
    Optional<Path> chooseFloorPlan() {
        JFileChooser chooser = createChooser("importPlan", "plan", FloorPlanFiles.EXTENSIONS.toArray(String[]::new));
        return selectedFile(chooser, chooser.showOpenDialog(parent));
    }

    /**
     * Asks for a file to write, of the same type as the suggestion; empty if cancelled. Before a file is replaced, a
     * question is asked from which the user can return to the choice.
     */
    Optional<Path> chooseFileToSave(String action, Path suggestion) {
        String name = suggestion.getFileName().toString();
        String extension = name.substring(name.lastIndexOf('.') + 1).toLowerCase(Locale.ROOT);
        EscapableFileChooser chooser = createChooser(action, extension);
        chooser.setSelectedFile(new File(folder, name));
        chooser.saveAs(extension, extensions(filterName(action, extension)));
        if (suggestion.isAbsolute()) {
            chooser.setSelectedFile(suggestion.toFile());
        }
        return selectedFile(chooser, chooser.showSaveDialog(parent));
    }

    /** Asks for a folder to write to, which is empty or does not exist; empty if cancelled. */
    Optional<Path> chooseNewFolder(String action, Path suggestion) {
        EscapableFileChooser chooser = new EscapableFileChooser(folder);
        chooser.setDialogTitle(Messages.get("files." + action));
        chooser.setFileSelectionMode(JFileChooser.DIRECTORIES_ONLY);
        chooser.suggestFolder(folder.toPath().resolve(suggestion));
        while (chooser.showSaveDialog(parent) == JFileChooser.APPROVE_OPTION) {
            File chosen = chooser.getSelectedFile();
            String[] content = chosen.list();
            if (!chosen.exists() || content != null && content.length == 0) {
                folder = chooser.getCurrentDirectory();
                return Optional.of(chosen.toPath());
            }
            JOptionPane.showMessageDialog(
                    parent,
                    TextWrap.wrap(Messages.get(
                            chosen.isFile() ? "files.folder.file" : "files.folder.used", chosen.getName())),
                    Messages.get("files." + action),
                    JOptionPane.WARNING_MESSAGE);
        }
        return Optional.empty();
    }

    /** Asks for a folder, or for a file in it that stands for it; empty if cancelled. */
    Optional<Path> chooseFolderOrFile(String action, String... extensions) {
        JFileChooser chooser = createChooser(action, action, extensions);
        chooser.setFileSelectionMode(JFileChooser.FILES_AND_DIRECTORIES);
        return selectedFile(chooser, chooser.showOpenDialog(parent));
    }

    /** Creates a chooser that shows a folder and that Escape closes. */
    static JFileChooser createChooser(File folder) {
        return new EscapableFileChooser(folder);
    }

    private EscapableFileChooser createChooser(String action, String extension) {
        String filter = filterName(action, extension);
        return createChooser(action, filter, extensions(filter).toArray(String[]::new));
    }

    /** Returns the extensions of the files that a filter shows. */
    static List<String> extensions(String filter) {
        return switch (filter) {
            case "xml" -> FileNames.SCENARIO_EXTENSIONS;
            case "batchPlan" -> List.of("xml");
            default -> List.of(filter);
        };
    }

    /** Returns the name of an action's filter: its own, if it has one, or that of all files of a type. */
    static String filterName(String action, String extension) {
        if (Messages.contains("files.filter." + action)) {
            return action;
        }
        return FileNames.SCENARIO_EXTENSIONS.contains(extension) ? "xml" : extension;
    }

    private EscapableFileChooser createChooser(String action, String filter, String... extensions) {
        EscapableFileChooser chooser = new EscapableFileChooser(folder);
        chooser.setDialogTitle(Messages.get("files." + action));
        chooser.setFileFilter(new FileNameExtensionFilter(Messages.get("files.filter." + filter), extensions));
        return chooser;
    }

    private Optional<Path> selectedFile(JFileChooser chooser, int answer) {
        if (answer != JFileChooser.APPROVE_OPTION) {
            return Optional.empty();
        }
        folder = chooser.getCurrentDirectory();
        return Optional.of(chooser.getSelectedFile().toPath());
    }

    /** Returns the file with the extension appended if it has none of the allowed ones. */
    static Path withExtension(Path file, String extension, List<String> allowed) {
        String name = file.getFileName().toString();
        String lowerCase = name.toLowerCase(Locale.ROOT);
        boolean has = allowed.stream().anyMatch(each -> lowerCase.endsWith("." + each));
        return has ? file : file.resolveSibling(name + "." + extension);
    }

    /**
     * A file chooser that Escape closes wherever the focus is, and that fits on the screen. It stays open if the file
     * to open does not exist, and if the file to save is a folder, a device or a pipe, or is not to be replaced. The
     * name of a file to save may contain the characters of a file name pattern.
     */
    static final class EscapableFileChooser extends JFileChooser {
        /** Appends the extension to the name of a file to save, null if none is saved. */
        private transient UnaryOperator<Path> completion;

        EscapableFileChooser(File folder) {
            super(folder);
        }

        @Override
        public void updateUI() {
            super.updateUI();
            setUI(new TypedNameUI(this));
        }

        /** Suggests a folder that does not exist, whose name Swing does not show. */
        void suggestFolder(Path suggestion) {
            setSelectedFile(suggestion.toFile());
            ((TypedNameUI) getUI()).setFileName(suggestion.toString());
        }

        /** Chooses a file to save, with an extension that is appended to names without an allowed one. */
        void saveAs(String extension, List<String> allowed) {
            completion = file -> withExtension(file, extension, allowed);
        }

        @Override
        public void approveSelection() {
            File file = getSelectedFile();
            Optional<String> problem = problem(file, getDialogType() == OPEN_DIALOG);
            if (problem.isEmpty() && completion != null) {
                file = completion.apply(file.toPath()).toFile();
                problem = savingProblem(file);
            }
            if (problem.isPresent()) {
                JOptionPane.showMessageDialog(
                        this, TextWrap.wrap(problem.get()), getDialogTitle(), JOptionPane.WARNING_MESSAGE);
            } else if (completion == null || confirmReplace(file)) {
                setSelectedFile(file);
                super.approveSelection();
            }
        }

        private boolean confirmReplace(File file) {
            return !file.exists()
                    || Dialogs.ask(
                                    this,
                                    Messages.get("files.replace.title"),
                                    Messages.get("files.replace", file.getName()),
                                    "files.replace.replace",
                                    "unsaved.cancel")
                            == 0;
        }

        @Override
        protected JDialog createDialog(Component parent) {
            JDialog dialog = super.createDialog(parent);
            EmptyToolTips.disable(dialog);
            ScreenFit.pack(dialog);
            dialog.setLocationRelativeTo(parent);
            dialog.getRootPane()
                    .registerKeyboardAction(
                            event -> cancelSelection(),
                            KeyStroke.getKeyStroke("ESCAPE"),
                            JComponent.WHEN_IN_FOCUSED_WINDOW);
            return dialog;
        }
    }

    /** Returns why a file cannot be chosen, given whether it is to be opened; empty if it can. */
    static Optional<String> problem(File file, boolean opens) {
        if (!isPath(file)) {
            return Optional.of(Messages.get("files.badName", file.getName()));
        }
        return opens && Files.notExists(file.toPath())
                ? Optional.of(Messages.get("files.missing", file.getPath()))
                : Optional.empty();
    }

    /** Returns why a file cannot be saved, which is known before it is written; empty if nothing is known. */
    static Optional<String> savingProblem(File file) {
        if (file.isDirectory()) {
            return Optional.of(Messages.get("files.isFolder", file.getName()));
        }
        if (file.exists() && !file.isFile()) {
            return Optional.of(Messages.get("files.isDevice", file.getName()));
        }
        File folder = file.getAbsoluteFile().getParentFile();
        return folder == null || folder.isDirectory()
                ? Optional.empty()
                : Optional.of(Messages.get("files.missing", folder.getPath()));
    }

    /** Returns whether the file system accepts the name of a file. */
    static boolean isPath(File file) {
        try {
            file.toPath();
            return true;
        } catch (InvalidPathException refused) {
            return false;
        }
    }

    /**
     * Takes what is typed in a dialog for saving as the name of a file, even if it looks like a pattern, for which
     * Swing filters the list, or is the name of a file where a folder is expected, for which Swing cancels.
     */
    private static final class TypedNameUI extends MetalFileChooserUI {

        private final Action approve = new AbstractAction() {
            @Override
            public void actionPerformed(ActionEvent event) {
                approve(event);
            }
        };

        TypedNameUI(JFileChooser chooser) {
            super(chooser);
        }

        @Override
        public Action getApproveSelectionAction() {
            return approve;
        }

        private void approve(ActionEvent event) {
            JFileChooser chooser = getFileChooser();
            File typed = new File(String.valueOf(getFileName()).strip());
            File file = typed.isAbsolute() ? typed : new File(chooser.getCurrentDirectory(), typed.getPath());
            boolean isName = file.isFile()
                    || !file.exists()
                            && PATTERN_CHARACTERS.matcher(file.getName()).find();
            if (chooser.getDialogType() == JFileChooser.SAVE_DIALOG && isName && !isDirectorySelected()) {
                chooser.setSelectedFile(file);
                chooser.approveSelection();
            } else {
                super.getApproveSelectionAction().actionPerformed(event);
            }
        }
    }

    /** Asks a question of the window, as {@link Dialogs#ask}, with the title of a key. */
    int showOptions(String key, String question, String... answerKeys) {
        return Dialogs.ask(parent, Messages.get(key + ".title"), question, answerKeys);
    }
}
