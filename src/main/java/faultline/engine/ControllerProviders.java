package faultline.engine;

import faultline.control.Controller;
import faultline.control.ControllerProvider;
import faultline.control.ControllerSpec;
import faultline.control.StateTracker;
import faultline.io.Message;
import faultline.io.MessageText;
import java.lang.reflect.Modifier;
import java.net.URI;
import java.nio.file.FileSystemNotFoundException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.security.CodeSource;
import java.util.Collections;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.ServiceConfigurationError;
import java.util.ServiceLoader;
import java.util.Set;
import java.util.SortedMap;
import java.util.TreeMap;
import java.util.WeakHashMap;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.TimeoutException;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/** The controllers in Java that are on the class path, or in jars that the thread's context class loader adds to it. */
public final class ControllerProviders {

    /** The names of the built-in controllers, which a provider must not have. */
    public static final Set<String> BUILT_IN_NAMES = Set.of(
            ControllerSpec.WallFollowing.TYPE,
            ControllerSpec.None.TYPE,
            ControllerSpec.Drive.TYPE,
            ControllerSpec.Extern.TYPE,
            ControllerSpec.Recorded.TYPE);

    private static final Pattern MISSING_CLASS = Pattern.compile(": Provider (\\S+) not found$");
    private static final Pattern NO_SUBTYPE = Pattern.compile(": (?:Provider )?(\\S+) not a subtype$");
    private static final Pattern NO_CONSTRUCTOR = Pattern.compile(": (\\S+) Unable to get public no-arg constructor");
    private static final Pattern NEWER_CLASS = Pattern.compile("^(\\S+) has been .*?class file version (\\d{2,4})\\.");
    /** The version of class files is this number more than that of Java. */
    private static final int VERSION_BEFORE_JAVA_1 = 44;

    /**
     * The names of the providers that a class loader finds, so that a campaign does not make its providers for each
     * question. Each run has providers of its own.
     */
    private static final Map<ClassLoader, List<String>> NAMES = Collections.synchronizedMap(new WeakHashMap<>());

    private ControllerProviders() {}

    /**
     * {@return a new provider of a name, if there is one}
     *
     * @param name the name of the controller
     * @throws RunFailedException if a provider cannot be loaded
     */
    public static Optional<ControllerProvider> find(String name) {
        return Optional.ofNullable(all(ControllerThread.TIMEOUT).get(name));
    }

    /**
     * {@return the names of all providers, in alphabetical order} The providers are made by the first call only.
     *
     * @throws RunFailedException if a provider cannot be loaded
     */
    public static List<String> names() {
        ClassLoader loader = Thread.currentThread().getContextClassLoader();
        List<String> known = NAMES.get(loader);
        if (known != null) {
            return known;
        }
        List<String> names = List.copyOf(all(ControllerThread.TIMEOUT).keySet());
        NAMES.put(loader, names);
        return names;
    }

    /**
     * {@return the jars that the providers were loaded from, by the names of their controllers, in alphabetical order}
     * One that was not loaded from a jar is not among them.
     *
     * @throws RunFailedException if a provider cannot be loaded
     */
    public static SortedMap<String, Path> jars() {
        SortedMap<String, Path> jars = new TreeMap<>();
        locations().forEach((name, location) -> file(location).ifPresent(jar -> jars.put(name, jar)));
        return jars;
    }

    /**
     * {@return the URLs of the jars or folders that the providers were loaded from, by the names of their controllers,
     * in alphabetical order} A URL that is not known is empty.
     *
     * @throws RunFailedException if a provider cannot be loaded
     */
    public static SortedMap<String, String> locations() {
        SortedMap<String, String> locations = new TreeMap<>();
        all(ControllerThread.TIMEOUT).forEach((name, provider) -> locations.put(name, location(provider)));
        return locations;
    }

    private static String location(ControllerProvider provider) {
        CodeSource source = provider.getClass().getProtectionDomain().getCodeSource();
        return source == null || source.getLocation() == null
                ? ""
                : source.getLocation().toString();
    }

    private static Optional<Path> file(String location) {
        try {
            return Optional.of(Path.of(URI.create(location))).filter(Files::isRegularFile);
        } catch (IllegalArgumentException | FileSystemNotFoundException e) {
            return Optional.empty();
        }
    }

    /**
     * {@return a new controller}
     *
     * @param name the name of its provider
     * @param settings for it
     * @throws RunFailedException if there is no such provider, or it fails or does not answer
     */
    public static Controller create(String name, Map<String, String> settings) {
        ControllerProvider provider =
                find(name).orElseThrow(() -> new RunFailedException(RunProblem.NO_CONTROLLER.with(name), null));
        return create(name, provider, settings);
    }

    /**
     * {@return a new controller}
     *
     * @param name the name of the provider
     * @param provider makes it
     * @param settings for it
     * @throws RunFailedException if the provider fails or does not answer
     */
    public static Controller create(String name, ControllerProvider provider, Map<String, String> settings) {
        return create(name, provider, settings, ControllerThread.TIMEOUT);
    }

    /** Returns a new controller; the time-out is in seconds. */
    static Controller create(String name, ControllerProvider provider, Map<String, String> settings, double timeout) {
        try {
            Controller controller = ControllerThread.call(
                    timeout, () -> Objects.requireNonNull(provider.create(settings), "create returned null"));
            return new StateTracker(controller, MessageText.name(name));
        } catch (ExecutionException e) {
            throw new RunFailedException(RunProblem.NOT_CREATED.with(name, e.getMessage()), e.getCause());
        } catch (TimeoutException e) {
            throw new RunFailedException(
                    RunProblem.NOT_CREATED.with(name, ControllerThread.silence("create", timeout)), e);
        }
    }

    /** Returns all providers by their names, in alphabetical order; the time-out of each call is in seconds. */
    static SortedMap<String, ControllerProvider> all(double timeout) {
        SortedMap<String, ControllerProvider> byName = new TreeMap<>();
        for (ServiceLoader.Provider<ControllerProvider> type : types()) {
            ControllerProvider provider = load(type, timeout);
            String name = name(provider, timeout);
            ControllerProvider other = byName.put(name, provider);
            if (BUILT_IN_NAMES.contains(name)) {
                throw new RunFailedException(RunProblem.BUILT_IN_NAME.with(className(provider), name), null);
            }
            if (other != null) {
                throw new RunFailedException(
                        RunProblem.SAME_NAME.with(className(other), className(provider), name), null);
            }
        }
        return byName;
    }

    private static List<ServiceLoader.Provider<ControllerProvider>> types() {
        try {
            return ServiceLoader.load(ControllerProvider.class).stream().toList();
        } catch (ServiceConfigurationError | LinkageError e) {
            throw new RunFailedException(problem(e), e);
        }
    }

    /** Says in other words what the JDK says of frequent mistakes. */
    private static Message problem(Error error) {
        String text = String.valueOf(error.getMessage());
        Matcher missing = MISSING_CLASS.matcher(text);
        if (missing.find()) {
            return RunProblem.NO_CLASS.with(missing.group(1), ControllerProvider.class.getName());
        }
        Matcher other = NO_SUBTYPE.matcher(text);
        if (other.find()) {
            return RunProblem.NO_PROVIDER.with(other.group(1), ControllerProvider.class.getName());
        }
        Matcher closed = NO_CONSTRUCTOR.matcher(text);
        if (closed.find()) {
            return RunProblem.NO_CONSTRUCTOR.with(closed.group(1));
        }
        Matcher newer = NEWER_CLASS.matcher(text);
        if (error instanceof UnsupportedClassVersionError && newer.find()) {
            return RunProblem.NEWER_JAVA.with(
                    newer.group(1).replace('/', '.'),
                    Integer.parseInt(newer.group(2)) - VERSION_BEFORE_JAVA_1,
                    Runtime.version().feature());
        }
        return RunProblem.NOT_LOADED.with(reason(error));
    }

    private static ControllerProvider load(ServiceLoader.Provider<ControllerProvider> type, double timeout) {
        String className = type.type().getName();
        try {
            return ControllerThread.call(timeout, () -> create(type));
        } catch (ExecutionException e) {
            throw RunFailedException.ofCall(e, RunProblem.NOT_LOADED);
        } catch (TimeoutException e) {
            String silence = ControllerThread.silence("the constructor of " + className, timeout);
            throw new RunFailedException(RunProblem.NOT_LOADED.with(silence), e);
        }
    }

    private static ControllerProvider create(ServiceLoader.Provider<ControllerProvider> type) {
        try {
            return type.get();
        } catch (ServiceConfigurationError | LinkageError e) {
            throw new RunFailedException(notCreated(type.type(), e), e);
        }
    }

    private static Message notCreated(Class<?> type, Throwable error) {
        if (error.getCause() instanceof InstantiationException && Modifier.isAbstract(type.getModifiers())) {
            return RunProblem.ABSTRACT_CLASS.with(type.getName());
        }
        if (error.getCause() instanceof IllegalAccessException && !Modifier.isPublic(type.getModifiers())) {
            return RunProblem.NO_CONSTRUCTOR.with(type.getName());
        }
        return RunProblem.NOT_LOADED.with(reason(error));
    }

    /** Returns the message of an error, with the exception of the provider's class or constructor that caused it. */
    private static String reason(Throwable error) {
        Throwable cause = error.getCause();
        return cause == null ? String.valueOf(error.getMessage()) : error.getMessage() + ": " + ExceptionText.of(cause);
    }

    private static String name(ControllerProvider provider, double timeout) {
        String name;
        try {
            name = ControllerThread.call(timeout, provider::name);
        } catch (ExecutionException e) {
            throw nameless(provider, e.getMessage(), e.getCause());
        } catch (TimeoutException e) {
            throw nameless(provider, ControllerThread.silence("name", timeout), e);
        }
        if (name == null || name.isBlank()) {
            throw nameless(provider, name == null ? "name returned null" : "name returned a blank", null);
        }
        return name;
    }

    private static RunFailedException nameless(ControllerProvider provider, String problem, Throwable cause) {
        return new RunFailedException(RunProblem.NAMELESS.with(className(provider), problem), cause);
    }

    private static String className(ControllerProvider provider) {
        return provider.getClass().getName();
    }
}
