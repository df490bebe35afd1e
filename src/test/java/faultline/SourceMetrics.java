package faultline;

import com.sun.source.tree.BlockTree;
import com.sun.source.tree.CompilationUnitTree;
import com.sun.source.tree.ImportTree;
import com.sun.source.tree.MemberSelectTree;
import com.sun.source.tree.MethodInvocationTree;
import com.sun.source.tree.MethodTree;
import com.sun.source.tree.PackageTree;
import com.sun.source.tree.Tree;
import com.sun.source.util.JavacTask;
import com.sun.source.util.SourcePositions;
import com.sun.source.util.TreeScanner;
import com.sun.source.util.Trees;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collection;
import java.util.List;
import java.util.Locale;
import java.util.regex.Pattern;
import javax.tools.JavaCompiler;
import javax.tools.StandardJavaFileManager;
import javax.tools.ToolProvider;

/** Measures source files, which are parsed once. */
final class SourceMetrics {

    private static final Pattern QUALIFIED_TYPE = Pattern.compile("(?:javax?|faultline)(?:\\.[a-z]\\w*)+\\.[A-Z]\\w*");

    private static final List<String> CASE_CHANGES = List.of("toLowerCase", "toUpperCase");

    private static final List<String> NEVER_WITH_LOCALE = List.of("formatted", "printf");

    private final List<CompilationUnitTree> units = new ArrayList<>();
    private final SourcePositions positions;

    /** Parses source files. */
    SourceMetrics(Collection<Path> files) throws IOException {
        JavaCompiler compiler = ToolProvider.getSystemJavaCompiler();
        try (StandardJavaFileManager manager =
                compiler.getStandardFileManager(null, Locale.ROOT, StandardCharsets.UTF_8)) {
            JavacTask task = (JavacTask) compiler.getTask(
                    null, manager, null, List.of("-proc:none"), null, manager.getJavaFileObjectsFromPaths(files));
            positions = Trees.instance(task).getSourcePositions();
            task.parse().forEach(units::add);
        }
    }

    /**
     * Returns the methods and constructors whose body is too long.
     *
     * @param most how many lines are allowed from the opening brace to the closing one, both included
     * @return "file:line name: lines" for each
     */
    List<String> longMethods(int most) {
        List<String> found = new ArrayList<>();
        units.forEach(unit -> unit.accept(new MethodMeter(unit, positions, most, found), null));
        return found;
    }

    /**
     * Returns the types that source files name with their packages instead of importing them. Comments and literals are
     * ignored.
     *
     * @return "file:line name" for each
     */
    List<String> qualifiedTypes() {
        List<String> found = new ArrayList<>();
        units.forEach(unit -> unit.accept(new QualifiedTypeFinder(unit, positions, found), null));
        return found;
    }

    /**
     * Returns the calls of methods that depend on the language of the machine although an argument could give another:
     * {@code String.format} would write the digits of that language, and {@code toLowerCase} its letters.
     *
     * @return "file:line call" for each
     */
    List<String> localizedCalls() {
        List<String> found = new ArrayList<>();
        units.forEach(unit -> unit.accept(new LocalizedCallFinder(unit, positions, found), null));
        return found;
    }

    /**
     * Returns the lines of a source file that are too long. Lines in text blocks may have any length, because a row of
     * a table is one line.
     *
     * @param source the text
     * @param most how many characters are allowed
     * @return the numbers of the lines, the first being 1
     */
    static List<Integer> longLines(String source, int most) {
        List<Integer> found = new ArrayList<>();
        boolean inTextBlock = false;
        List<String> lines = source.lines().toList();
        for (int i = 0; i < lines.size(); i++) {
            String line = lines.get(i);
            if (!inTextBlock && line.length() > most) {
                found.add(i + 1);
            }
            inTextBlock ^= line.split("\"\"\"", -1).length % 2 == 0;
        }
        return found;
    }

    /** Visits the tree of one source file and adds what it finds to a list, each with its place. */
    private abstract static class Finder extends TreeScanner<Void, Void> {

        private final CompilationUnitTree unit;
        private final SourcePositions positions;
        private final List<String> found;

        Finder(CompilationUnitTree unit, SourcePositions positions, List<String> found) {
            this.unit = unit;
            this.positions = positions;
            this.found = found;
        }

        /** Returns the number of the line in which a part of the file begins. */
        long firstLine(Tree part) {
            return unit.getLineMap().getLineNumber(positions.getStartPosition(unit, part));
        }

        /** Returns the number of the line in which a part of the file ends. */
        long lastLine(Tree part) {
            return unit.getLineMap().getLineNumber(positions.getEndPosition(unit, part));
        }

        /** Adds "file:line text" for a part of the file. */
        void add(Tree part, String text) {
            found.add(unit.getSourceFile().getName() + ":" + firstLine(part) + " " + text);
        }
    }

    /** Adds a line for each method that is too long. */
    private static final class MethodMeter extends Finder {

        private final int most;

        MethodMeter(CompilationUnitTree unit, SourcePositions positions, int most, List<String> found) {
            super(unit, positions, found);
            this.most = most;
        }

        @Override
        public Void visitMethod(MethodTree method, Void none) {
            BlockTree body = method.getBody();
            if (body != null) {
                long lines = lastLine(body) - firstLine(body) + 1;
                if (lines > most) {
                    add(body, method.getName() + ": " + lines);
                }
            }
            return super.visitMethod(method, none);
        }
    }

    /** Adds a line for each call that depends on the language of the machine. */
    private static final class LocalizedCallFinder extends Finder {

        LocalizedCallFinder(CompilationUnitTree unit, SourcePositions positions, List<String> found) {
            super(unit, positions, found);
        }

        @Override
        public Void visitMethodInvocation(MethodInvocationTree call, Void none) {
            String select = call.getMethodSelect().toString();
            String method = select.substring(select.lastIndexOf('.') + 1);
            boolean takesLocale = select.equals("String.format") || CASE_CHANGES.contains(method);
            boolean needsLocale = takesLocale && !select.startsWith("Character.") || NEVER_WITH_LOCALE.contains(method);
            if (needsLocale
                    && call.getArguments().stream()
                            .noneMatch(argument -> argument.toString().startsWith("Locale."))) {
                add(call, method);
            }
            return super.visitMethodInvocation(call, none);
        }
    }

    /** Adds a line for each type that is named with its package. */
    private static final class QualifiedTypeFinder extends Finder {

        QualifiedTypeFinder(CompilationUnitTree unit, SourcePositions positions, List<String> found) {
            super(unit, positions, found);
        }

        @Override
        public Void visitPackage(PackageTree declaration, Void none) {
            return null;
        }

        @Override
        public Void visitImport(ImportTree declaration, Void none) {
            return null;
        }

        @Override
        public Void visitMemberSelect(MemberSelectTree select, Void none) {
            if (QUALIFIED_TYPE.matcher(select.toString()).matches()) {
                add(select, select.toString());
            }
            return super.visitMemberSelect(select, none);
        }
    }
}
