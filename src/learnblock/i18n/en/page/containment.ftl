# What programs may do: what contains them on the server's computer, and the network.

page-containment-title = What programs may do
page-containment-menu = What programs may do…
page-containment-help = On the computer that runs LearnBlock, a test program has tried to get past the limits of all programs:
page-containment-trying = Trying out what programs can do…
page-containment-attempt = What a program tries
page-containment-result = Result
page-containment-reason = Why
page-containment-refused = Refused
page-containment-allowed = Allowed
page-containment-warning = On this computer, programs can get past LearnBlock's limits. Run only programs that you trust.
page-containment-details = Show details
page-containment-network = Network
# $name is the name of a project.
page-containment-network-allow = Programs of the project "{ $name }" may use the network
page-containment-network-help = Takes effect with the next run. Everyone who can open this page can change the project, so allow it only if you trust them.
