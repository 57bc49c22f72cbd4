# The server: where it listens, who may use it, and messages from pages that it can't carry out.

## Starting

# $address is the address of the page.
server-started =
    LearnBlock is running at { $address }
    Press Ctrl-C to stop it.
# $reason is the system's text.
server-cannot-listen = LearnBlock can't listen at { $host }, port { $port }: { $reason }. Choose another --port.
server-cannot-listen-socket = LearnBlock can't listen at { $path }: { $reason }.
server-already-listening = Another LearnBlock is listening at { $path }.
# $variable is the name of an environment variable.
server-token-wrong = { $variable } can only contain letters, digits, '-', '_', '.' and '~'.
server-no-window = A window needs pywebview. Run pip install 'learnblock-studio[window]', or leave out --window and use the browser.

## Answers to a browser

# The title of the page below.
server-incomplete-address-title = This address is incomplete
server-incomplete-address = Open the whole address that LearnBlock printed when it started. It ends in ?token= and a long word, and is new each time.
server-wrong-address = LearnBlock does not accept this address or this page. Open the address that LearnBlock printed; behind a proxy, start LearnBlock with --allow-host NAME.
server-not-built-title = The page has not been built
server-not-built = This LearnBlock runs from its sources, without a built page. Build the page with Node.js, and reload:
server-no-floor-picture = The floor of this world has no picture.

## Messages from a page

# $reason is a technical text in English.
server-mistake = Something went wrong in LearnBlock: { $reason }
server-no-project = No project is open. Open a project first.
server-too-deep = This is nested too deeply.
server-message-too-long = A message of { $count } characters is too long.
server-message-unknown = LearnBlock doesn't know this message: { $reason }
server-message-broken = This message is nested too deeply, or is not text.
# $problem is a sentence.
server-block-set-file = The file '{ $name }' is not a block set. { $problem }
server-world-exists = You already have a world '{ $name }'. Choose another name, or save again to replace it.

## For contributors: learnblock dev

server-dev-no-watchfiles = learnblock dev needs watchfiles. Run pip install -e '.[dev]'.
server-dev-no-checkout = learnblock dev needs the sources of LearnBlock, including the frontend folder. To use the page, run learnblock.
server-dev-no-node = learnblock dev needs Node.js { $version } or newer.
server-dev-started = The page with hot reload: { $address }
