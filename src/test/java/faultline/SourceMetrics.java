package faultline;

import com.sun.source.tree.CompilationUnitTree;
import com.sun.source.tree.ImportTree;
import com.sun.source.tree.LineMap;
import com.sun.source.tree.MemberSelectTree;
import com.sun.source.tree.MethodInvocationTree;
import com.sun.source.tree.MethodTree;
import com.sun.source.tree.PackageTree;
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
import java.util.function.BiFunction;
import java.util.regex.Pattern;
import javax.tools.JavaCompiler;
import javax.tools.StandardJavaFileManager;
import javax.tools.ToolProvider;

/** Measures source files. */
final class SourceMetrics {

    private static final Pattern QUALIFIED_TYPE = Pattern.compile("(?:javax?|faultline)(?:\\.[a-z]\\w*)+\\.[A-Z]\\w*");

    private static final List<String> CASE_CHANGES = List.of("toLowerCase", "toUpperCase");

    private static final List<String> NEVER_WITH_LOCALE = List.of("formatted", "printf");

    private SourceMetrics() {}

    /**
     * Returns the methods and constructors whose body is too long.
     *
     * @param files source files
     * @param most how many lines are allowed from the opening brace to the closing one, both included
     * @return "file:line name: lines" for each
     */
    static List<String> longMethods(Collection<Path> files, int most) throws IOException {
        List<String> found = new ArrayList<>();
        scan(files, (unit, positions) -> new MethodMeter(unit, positions, most, found));
        return found;
    }

    /**
     * Returns the types that source files name with their packages instead of importing them. Comments and literals are
     * ignored.
     *
     * @param files source files
     * @return "file:line name" for each
     */
    static List<String> qualifiedTypes(Collection<Path> files) throws IOException {
        List<String> found = new ArrayList<>();
        scan(files, (unit, positions) -> new QualifiedTypeFinder(unit, positions, found));
        return found;
    }

    /**
     * Returns the calls of methods that depend on the language of the machine although an argument could give another:
     * {@code String.format} would write the digits of that language, and {@code toLowerCase} its letters.
     *
     * @param files source files
     * @return "file:line call" for each
     */
    static List<String> localizedCalls(Collection<Path> files) throws IOException {
        List<String> found = new ArrayList<>();
        scan(files, (unit, positions) -> new LocalizedCallFinder(unit, positions, found));
        return found;
    }

    private static void scan(
            Collection<Path> files, BiFunction<CompilationUnitTree, SourcePositions, TreeScanner<Void, Void>> scanner)
            throws IOException {
        JavaCompiler compiler = ToolProvider.getSystemJavaCompiler();
        try (StandardJavaFileManager manager =
                compiler.getStandardFileManager(null, Locale.ROOT, StandardCharsets.UTF_8)) {
            JavacTask task = (JavacTask) compiler.getTask(
                    null, manager, null, List.of("-proc:none"), null, manager.getJavaFileObjectsFromPaths(files));
            SourcePositions positions = Trees.instance(task).getSourcePositions();
            for (CompilationUnitTree unit : task.parse()) {
                unit.accept(scanner.apply(unit, positions), null);
            }
        }
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

    /** Adds a line for each method that is too long. */
    private static final class MethodMeter extends TreeScanner<Void, Void> {

        private final CompilationUnitTree unit;
        private final SourcePositions positions;
        private final int most;
        private final List<String> found;

        MethodMeter(CompilationUnitTree unit, SourcePositions positions, int most, List<String> found) {
            this.unit = unit;
            this.positions = positions;
            this.most = most;
            this.found = found;
        }

        @Override
        public Void visitMethod(MethodTree method, Void none) {
            if (method.getBody() != null) {
                LineMap map = unit.getLineMap();
                long first = map.getLineNumber(positions.getStartPosition(unit, method.getBody()));
                long last = map.getLineNumber(positions.getEndPosition(unit, method.getBody()));
                if (last - first + 1 > most) {
                    found.add(unit.getSourceFile().getName() + ":" + first + " " + method.getName() + ": "
                            + (last - first + 1));
                }
            }
            return super.visitMethod(method, none);
        }
    }

    /** Adds a line for each call that depends on the language of the machine. */
    private static final class LocalizedCallFinder extends TreeScanner<Void, Void> {

        private final CompilationUnitTree unit;
        private final SourcePositions positions;
        private final List<String> found;

        LocalizedCallFinder(CompilationUnitTree unit, SourcePositions positions, List<String> found) {
            this.unit = unit;
            this.positions = positions;
            this.found = found;
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
                long line = unit.getLineMap().getLineNumber(positions.getStartPosition(unit, call));
                found.add(unit.getSourceFile().getName() + ":" + line + " " + method);
            }
            return super.visitMethodInvocation(call, none);
        }
    }

    /** Adds a line for each type that is named with its package. */
    private static final class QualifiedTypeFinder extends TreeScanner<Void, Void> {

        private final CompilationUnitTree unit;
        private final SourcePositions positions;
        private final List<String> found;

        QualifiedTypeFinder(CompilationUnitTree unit, SourcePositions positions, List<String> found) {
            this.unit = unit;
            this.positions = positions;
            this.found = found;
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
                long line = unit.getLineMap().getLineNumber(positions.getStartPosition(unit, select));
                found.add(unit.getSourceFile().getName() + ":" + line + " " + select);
            }
            return super.visitMemberSelect(select, none);
        }
    }
}
